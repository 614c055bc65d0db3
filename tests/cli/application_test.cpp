// Parsing of the command line, help and usage errors.
#include "cli/application.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <vector>

#include "cli/terminal/exit_code.h"
#include "tests/support/json.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

struct Answer {
  int exit_code;
  std::string out;
  std::string err;
};

using Words = std::vector<std::string>;

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Answer run(const Words& words) {
  std::vector<const char*> arguments = {"cls"};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int exit_code = cls::cli::run_application(
      *cls::cli::command_tree(), static_cast<int>(arguments.size()), arguments.data());
  std::fflush(stdout);
  std::fflush(stderr);
  std::string out = testing::internal::GetCapturedStdout();
  return {exit_code, out, testing::internal::GetCapturedStderr()};
}

TEST(Application, PrintsVersionOnStdout) {
  const Answer answer = run({"version"});
  EXPECT_EQ(answer.exit_code, cls::cli::kOk);
  EXPECT_EQ(answer.out.substr(0, 6), "cls 0.");
  EXPECT_EQ(answer.err, "");
}

TEST(Application, PrintsHelpOnStdoutWithExamplesFirst) {
  const Answer answer = run({"--help"});
  EXPECT_EQ(answer.exit_code, cls::cli::kOk);
  EXPECT_THAT(answer.out, HasSubstr("  match         play one match and print its result\n"));
  EXPECT_LT(answer.out.find("cls match mock mock"), answer.out.find("Usage: cls"))
      << "examples come first";
}

// The command names in the help of a group.
std::vector<std::string> listed_commands(const std::string& help) {
  std::vector<std::string> names;
  std::istringstream lines(help.substr(help.find("COMMAND\n")));
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > 2 && line.starts_with("  ") && std::islower(line[2]) != 0) {
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
  }
  return names;
}

std::vector<Words> commands_of(const Words& group) {
  const std::string help = run(with(group, {"--help"})).out;
  if (help.find("COMMAND\n") == std::string::npos) return {group};
  std::vector<Words> all;
  for (const std::string& name : listed_commands(help)) {
    if (name == "help") continue;
    const std::vector<Words> below = commands_of(with(group, {name}));
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

// All commands that have arguments of their own: {"match"}, {"check", "server"}, ...
const std::vector<Words>& commands() {
  static const std::vector<Words> all = commands_of({});
  return all;
}

TEST(Application, HelpListsAllCommands) {
  const std::vector<Words>& all = commands();
  for (const Words& words : {Words{"match"}, Words{"tournament", "work"}, Words{"version"},
                             Words{"check", "perception"}, Words{"server"}}) {
    EXPECT_NE(std::ranges::find(all, words), all.end()) << words.front();
  }
  EXPECT_GE(all.size(), 22u);
}

TEST(Application, HelpFits80Columns) {
  std::vector<Words> all = commands();
  all.insert(all.end(), {{}, {"tournament"}, {"check"}});
  for (const Words& words : all) {
    const Answer answer = run(with(words, {"--help"}));
    EXPECT_EQ(answer.exit_code, cls::cli::kOk);
    std::istringstream help(answer.out);
    for (std::string line; std::getline(help, line);) {
      EXPECT_LE(line.size(), 80u) << line;
      EXPECT_FALSE(line.ends_with(' ')) << "'" << line << "'";
    }
  }
}

// A line of an option's help ends where the next word does not fit.
TEST(Application, HelpFoldsOptionsAtItsWidthOnly) {
  constexpr std::size_t kColumn = 30;
  const std::string margin(kColumn, ' ');
  for (const Words& words : commands()) {
    const std::string text = run(with(words, {"--help"})).out;
    std::istringstream help(text.substr(text.find("\nOptions:\n")));
    std::string before;
    for (std::string line; std::getline(help, line); before = line) {
      const bool continues = line.starts_with(margin) && line[kColumn] != ' ';
      if (!continues || before.size() <= kColumn || before[kColumn - 1] != ' ') continue;
      const std::string word = line.substr(kColumn, line.find(' ', kColumn) - kColumn);
      EXPECT_GT(before.size() + 1 + word.size(), 80U) << before << "\n" << line;
    }
  }
}

TEST(Application, HelpNamesNoTypeOfTheParser) {
  for (const Words& words : commands()) {
    const std::string help = run(with(words, {"--help"})).out;
    for (const char* raw : {" INT", " UINT", " FLOAT", " TEXT", "REQUIRED", "{false}", ":POS"}) {
      EXPECT_THAT(help, Not(HasSubstr(raw))) << raw;
    }
  }
}

TEST(Application, HelpStartsWithPurposeThenExamples) {
  for (const Words& words : commands()) {
    const std::string help = run(with(words, {"--help"})).out;
    const std::size_t example = help.find("\n  cls " + words.front());
    EXPECT_LT(example, help.find("\nUsage: cls ")) << help;
    EXPECT_TRUE(std::islower(help.front())) << help;
  }
}

TEST(Application, HelpGroupsOptions) {
  const std::string help = run({"match", "--help"}).out;
  std::size_t last = 0;
  for (const char* group : {"\nArguments:\n", "\nOptions:\n", "\nTeams:\n", "\nOutput:\n"}) {
    const std::size_t at = help.find(group);
    ASSERT_NE(at, std::string::npos) << group << help;
    EXPECT_LT(last, at) << group;
    last = at;
  }
  EXPECT_GT(help.find("--no-color"), last);
}

TEST(Application, HelpCommandPrintsTheHelpOfACommand) {
  EXPECT_EQ(run({"help"}).out, run({"--help"}).out);
  EXPECT_EQ(run({"help", "match"}).out, run({"match", "--help"}).out);
  EXPECT_EQ(run({"help", "tournament", "run"}).out, run({"tournament", "run", "--help"}).out);
  const Answer unknown = run({"help", "tournament", "rnu"});
  EXPECT_EQ(unknown.exit_code, cls::cli::kUsage);
  EXPECT_EQ(unknown.err, "cls: unknown command 'rnu'; did you mean 'run'?\n");
}

TEST(Application, VersionOptionIsTheVersionCommand) {
  const std::string version = run({"version"}).out;
  EXPECT_EQ(run({"--version"}).out, version);
  EXPECT_EQ(run({"-V"}).out, version);
  EXPECT_EQ(run({"--version", "--json"}).out, run({"version", "--json"}).out);
}

TEST(Application, VersionNamesReleaseWireCompilerAndLibraries) {
  const base::Json printed = base::Json::parse(run({"version", "--json"}).out);
  EXPECT_EQ(printed["schema"], "cls.version/1");
  const std::string text = run({"version"}).out;
  for (const char* key : {"cls", "wire", "compiler"}) {
    EXPECT_THAT(text, HasSubstr(printed[key].get<std::string>())) << key;
  }

  EXPECT_EQ(printed["protocol"]["newest"], 19);
  for (const auto& [name, version] : printed["formats"].items()) {
    EXPECT_THAT(text, HasSubstr(name)) << name;
    EXPECT_THAT(text, HasSubstr(version.get<std::string>())) << name;
  }

  for (const char* library : {"grpc", "protobuf", "boost", "sqlite", "zlib", "nlohmann-json",
                              "openssl", "sleef", "tomlplusplus"}) {
    ASSERT_TRUE(printed["libraries"].contains(library)) << printed;
    EXPECT_THAT(text, HasSubstr(printed["libraries"][library].get<std::string>()));
  }
}

TEST(Application, SharedFlagsMayPrecedeTheCommand) {
  EXPECT_EQ(run({"--json", "version"}).out, run({"version", "--json"}).out);
  const std::string missing = "/nonexistent/cup";
  const Answer answer = run({"--no-color", "--json", "tournament", "status", missing});
  EXPECT_EQ(answer.err, run({"tournament", "status", missing}).err);
}

TEST(Application, AllCommandsTakeTheSharedFlags) {
  for (const Words& words : commands()) {
    const std::string help = run(with(words, {"--help"})).out;
    for (const char* flag : {"  --json ", "  --quiet ", "  --no-color "}) {
      EXPECT_THAT(help, HasSubstr(flag)) << flag;
    }
  }
}

struct Mistake {
  Words words;
  std::string error;
};

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> table = {
      {{}, "no command; see cls --help, or begin with: cls match mock mock"},
      {{"mach", "mock", "mock"}, "unknown command 'mach'; did you mean 'match'?"},
      {{"mtch", "mock", "mock"}, "unknown command 'mtch'; did you mean 'match'?"},
      {{"--quiet", "mach", "mock", "mock"}, "unknown command 'mach'; did you mean 'match'?"},
      {{"zzz"}, "unknown command 'zzz' (see cls --help)"},
      {{"tournament", "rnu"}, "unknown command 'rnu'; did you mean 'run'?"},
      {{"check", "servr"}, "unknown command 'servr'; did you mean 'server'?"},
      {{"check"}, "check requires a command: playmaker, server, server-log, perception"},
      {{"match"}, "LEFT and RIGHT are required (see cls match --help)"},
      {{"match", "mock", "mock", "mock"}, "unknown argument 'mock' (see cls match --help)"},
      {{"match", "mock", "mock", "--cycles"}, "--cycles requires a value: a whole number"},
      {{"match", "mock", "mock", "--dir"}, "--dir requires a value: a folder"},
      {{"match", "mock", "mock", "--cycles", "1", "--cycles", "2"},
       "--cycles is given 2 times; only once is possible"},
      {{"match", "mock", "mock", "--seed", "abc"},
       "--seed 'abc': must be a whole number, 0 or more"},
      {{"match", "mock", "mock", "--seed", ""}, "--seed '': must be a whole number, 0 or more"},
      {{"match", "mock", "mock", "--seed", "-1"}, "--seed '-1': must be a whole number, 0 or more"},
      {{"match", "mock", "mock", "--seed", "99999999999999999999999"},
       "--seed '99999999999999999999999': too large"},
      {{"match", "mock", "mock", "--cycles", "99999999999"}, "--cycles '99999999999': too large"},
      {{"match", "mock", "mock", "--cycles", "0x10"}, "--cycles '0x10': must be a whole number"},
      {{"match", "mock", "mock", "--time-limit", "nan"}, "--time-limit 'nan': must be a number"},
      {{"match", "mock", "mock", "--json=maybe"}, "--json takes no value (see cls match --help)"},
      {{"match", "mock", "mock", "--json", "--json"},
       "--json takes no value (see cls match --help)"},
      {{"match", "mock", "mock", "--no-such", "--cycles"},
       "unknown option '--no-such'; did you mean '--no-coach'?"},
      {{"match", "mock", "mock", "--cycles="}, "--cycles requires a value: a whole number"},
      {{"match", "mock", "mock", "--set"}, "--set requires a value: NAME=VALUE"},
      {{"match", "mock", "mock", "--set", "a=1", "--set"}, "--set requires a value: NAME=VALUE"},
      {{"proxy", "-p"}, "--port requires a value: a whole number from 1 to 65535"},
      {{"proxy", "-rp"}, "--port requires a value: a whole number from 1 to 65535"},
      {{"mock", "--port", "70000"}, "--port '70000': must be a whole number from 0 to 65535"},
      {{"mock", "--port", "x"}, "--port 'x': must be a whole number from 0 to 65535"},
      {{"mock", "--delay", "-1"}, "--delay '-1': must be a whole number from 0"},
      {{"mock", "--drop", "2"}, "--drop '2': must be a number from 0 to 1"},
      {{"mock", "--fault-cycles", "3"}, "--fault-cycles requires 2 values: FROM TO"},
      {{"check", "playmaker", "mock", "--calls", "0"},
       "--calls '0': must be a whole number above 0"},
      {{"proxy", "--on-late", "hol"},
       "--on-late 'hol': must be hold, last or default; did you mean 'hold'?"},
      {{"match", "mock", "mock", "--on-late", "hol"},
       "--on-late 'hol': must be hold, last or default; did you mean 'hold'?"},
      {{"match", "mock", "mock", "--batch", "x"}, "--batch 'x': must be auto, never or always"},
      {{"match", "mock", "mock", "--mode", ""}, "--mode '': must be lockstep, synch or realtime"},
      {{"match", "mock", "mock", "--left-name", ""}, "--left-name '': must be a name"},
      {{"match", "mock", "mock", "--right-name", ""}, "--right-name '': must be a name"},
      {{"match", "mock", "mock", "--dir", ""}, "--dir '': must be a folder"},
      {{"match", "mock", "mock", "--config", ""}, "--config '': must be a file"},
      {{"match", "mock", "mock", "--at", "-3"}, "--at '-3': must be a whole number from 0"},
      {{"match", "mock", "mock", "--max-missed", "-1"},
       "--max-missed '-1': must be a whole number from 0"},
      {{"mock", "--host", ""}, "--host '': must be a host"},
  };

  return table;
}

TEST(Application, UsageErrorsNameArgumentValueAndForm) {
  for (const Mistake& mistake : mistakes()) {
    const Answer answer = run(mistake.words);
    EXPECT_EQ(answer.exit_code, cls::cli::kUsage) << mistake.error;
    EXPECT_EQ(answer.err, "cls: " + mistake.error + "\n");
    EXPECT_EQ(answer.out, "");
  }
}

TEST(Application, UnknownOptionOfEveryCommandHasASuggestion) {
  for (const Words& words : commands()) {
    const Answer answer = run(with(words, {"--quite"}));
    EXPECT_EQ(answer.exit_code, cls::cli::kUsage);
    EXPECT_EQ(answer.err, "cls: unknown option '--quite'; did you mean '--quiet'?\n");
  }
}

TEST(Application, ReportsUnknownCommandInOneLine) {
  const Answer answer = run({"mtach"});
  EXPECT_EQ(answer.exit_code, cls::cli::kUsage);
  EXPECT_EQ(answer.out, "");
  EXPECT_THAT(answer.err, HasSubstr("mtach"));
  EXPECT_EQ(answer.err.find('\n'), answer.err.size() - 1) << answer.err;
}

TEST(Application, ReportsUsageErrorWithoutCommand) {
  EXPECT_EQ(run({}).exit_code, cls::cli::kUsage);
}

}  // namespace
}  // namespace cls::tests
