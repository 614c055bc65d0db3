// The example team in every language whose tools are on the host: the same replies to recorded
// States, the same match with either service, and a project of `cls new` that passes its tests.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/text/json.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/language.h"
#include "tests/support/python.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using Words = std::vector<std::string>;
constexpr std::chrono::seconds kLong{1500};

// True if a test of this run, or of one shortly before, wrote the file.
bool is_fresh(const fs::path& file) {
  std::error_code none;
  const auto written = fs::last_write_time(file, none);
  return !none && fs::file_time_type::clock::now() - written < std::chrono::minutes(10);
}

CommandResult run_in(const fs::path& folder, const Words& words, const Words& environment = {}) {
  Command command(words, environment, folder);
  return command.finish(kLong);
}

fs::path example(const std::string& language) { return source_folder() / "examples" / language; }

bool is_long_form() { return std::getenv("CLS_LANGUAGES") != nullptr; }

class Languages : public testing::TestWithParam<Language> {
 protected:
  void SetUp() override {
    const Language& language = GetParam();
    const std::string missing = why_missing(language);
    if (!missing.empty()) GTEST_SKIP() << missing;
    build(example(language.name));
  }

  // One build of a folder at a time: ctest runs several tests of a language together. The first
  // one that reaches no registry spares the others the wait.
  void build(const fs::path& folder) const {
    const std::string no_registry = GetParam().name + ": cannot reach the registry of its packages";
    const fs::path unreachable = example(GetParam().name) / ".build/unreachable";
    if (is_fresh(unreachable)) GTEST_SKIP() << no_registry;

    fs::create_directories(folder / ".build");
    const CommandResult built =
        run_in(folder, {"flock", folder / ".build/lock", "./run", "build"}, environment());
    if (built.exit_code != 0 && is_about_network(built.out + built.err)) {
      std::ofstream(unreachable) << built.out << built.err;
      GTEST_SKIP() << no_registry;
    }
    ASSERT_EQ(built.exit_code, 0) << built.out << built.err;
  }

  // Projects share the compiled packages of the example (cargo since 1.91; other tools always do).
  static Words environment() {
    return {"CARGO_BUILD_BUILD_DIR=" + (example("rust") / ".build").string(), "CARGO_NET_RETRY=0"};
  }

  // The game log of a short match of a team in `language` against mock.
  std::string game_log(const std::string& language, const std::string& batch) {
    const fs::path dir = folder_.path() / (language + "-" + batch);
    const CommandResult played = run_in(
        folder_.path(), {cls_binary(), "match",
                         "run:" + (example(language) / "run").string() + " --port {port} --coach",
                         "mock", "--left-name", "team", "--seed", "4", "--cycles", "300", "--batch",
                         batch, "--start-timeout", "300", "--dir", dir});
    EXPECT_EQ(played.exit_code, 0) << played.err;
    return read_file(dir / "match.rcg");
  }

  fs::path new_project(const std::string& name, const std::string& team_template) const {
    const CommandResult written = run_in(
        folder_.path(), {cls_binary(), "new", GetParam().name, name, "--template", team_template});
    EXPECT_EQ(written.exit_code, 0) << written.err;
    return folder_.path() / name;
  }

  // The goals of the left and the right side in a match that is played in a project, after a build.
  std::pair<int, int> goals(const fs::path& project, const Words& match) const {
    build(project);
    Words command = {cls_binary(), "match", "--json"};
    command.insert(command.end(), match.begin(), match.end());
    const CommandResult played = run_in(project, command, environment());
    EXPECT_EQ(played.exit_code, 0) << played.err;
    const auto result = base::Json::parse_or_discarded(played.out);
    return {result["left"]["score"].get<int>(), result["right"]["score"].get<int>()};
  }

  // Runs a command of a page as its reader does.
  static CommandResult follow(const fs::path& project, const std::string& command) {
    const std::string path = cls_binary().parent_path().string() + ":" + std::getenv("PATH");
    return run_in(project, {"sh", "-c", command}, {"PATH=" + path});
  }

  TemporaryFolder folder_;
};

TEST_P(Languages, RepliesToRecordedStates) {
  const CommandResult tested = run_in(example(GetParam().name), {"./run", "test"});
  EXPECT_EQ(tested.exit_code, 0) << tested.out << tested.err;
}

TEST_P(Languages, PlaySameMatchWithEitherService) {
  const std::string single = game_log(GetParam().name, "never");
  EXPECT_GT(single.size(), 10000U);
  EXPECT_TRUE(game_log(GetParam().name, "always") == single) << "differs with one call per team";

  if (GetParam().name == "python" || python_with_grpc().empty()) return;
  build(example("python"));
  if (HasFatalFailure() || IsSkipped()) return;
  EXPECT_TRUE(game_log("python", "always") == single) << "differs from the match in Python";
}

TEST_P(Languages, NewProjectPassesItsTests) {
  const Words templates =
      is_long_form() ? Words{"team", "minimal", "high-level", "rl"} : Words{"team"};
  for (const std::string& team_template : templates) {
    SCOPED_TRACE(team_template);
    const CommandResult written =
        run_in(folder_.path(), {cls_binary(), "new", GetParam().name, "ada", "--template",
                                team_template, "--dir", team_template});
    ASSERT_EQ(written.exit_code, 0) << written.err;

    const fs::path project = folder_.path() / team_template;
    build(project);
    if (HasFatalFailure() || IsSkipped()) return;

    for (const Words& words :
         {Words{"match", "ada", "mock", "--cycles", "50", "--dir", "match", "--strict"},
          Words{"test", "tests/"},
          Words{"check", "playmaker", "run:./run --port {port}", "--latency-limit", "2000"}}) {
      Words command = {cls_binary()};
      command.insert(command.end(), words.begin(), words.end());
      const CommandResult result = run_in(project, command, environment());
      EXPECT_EQ(result.exit_code, 0) << words[0] << "\n" << result.out << result.err;
    }
  }
}

// The system's Python plays the other tests. This one has grpcio from a package index.
TEST(LanguagesOfPip, PythonRepliesToRecordedStates) {
  const fs::path environment = fs::path(CLS_BUILD_DIR) / "python-environment";
  if (run({environment / "bin/python", "-c", "import grpc_tools"}).exit_code != 0) {
    GTEST_SKIP() << "no grpcio of pip: python/tests/environment build";
  }

  // A copy: the system's Python has other generated modules.
  TemporaryFolder folder;
  for (const char* name : {"proto", "python", "fixtures"}) {
    fs::create_directory_symlink(source_folder() / name, folder.path() / name);
  }
  const fs::path team = folder.path() / "examples/python";
  fs::create_directories(team);
  for (const auto& file : fs::directory_iterator(example("python"))) {
    if (file.is_regular_file()) fs::copy_file(file, team / file.path().filename());
  }

  const CommandResult tested =
      run_in(team, {"./run", "test"}, {"VIRTUAL_ENV=" + environment.string()});
  EXPECT_EQ(tested.exit_code, 0) << tested.out << tested.err;
}

constexpr const char* kFirstChapter = "docs/tutorial.md";
constexpr const char* kSecondChapter = "docs/tutorial-2.md";

// The lines below `<!-- change: LANGUAGE FILE -->` in a page, and the file.
std::pair<std::string, std::vector<std::string>> change_of(const std::string& page,
                                                           const std::string& language) {
  std::istringstream text(read_file(source_folder() / page));
  const std::string mark = "<!-- change: " + language + " ";
  std::pair<std::string, std::vector<std::string>> change;
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with(mark)) continue;

    change.first = line.substr(mark.size(), line.size() - mark.size() - 4);
    std::getline(text, line);  // ```LANGUAGE
    while (std::getline(text, line) && line != "```") change.second.push_back(line);
  }
  return change;
}

// Puts the change in the place of the one line that `replaces` it; returns how many there are.
template <typename Replaces>
int replace_line(const std::vector<std::string>& change, const fs::path& file, Replaces replaces) {
  std::vector<std::string> lines;
  int found = 0;
  std::istringstream text(read_file(file));
  for (std::string line; std::getline(text, line);) {
    lines.push_back(line);
    if (!replaces(line)) continue;
    ++found;
    lines.pop_back();
    lines.insert(lines.end(), change.begin(), change.end());
  }
  std::ofstream out(file);
  for (const std::string& line : lines) out << line << "\n";
  return found;
}

// Replaces the line of the kick.
void replace_kick(const std::vector<std::string>& change, const fs::path& file) {
  const int found = replace_line(change, file, [](const std::string& line) {
    return line.find("smart_kick(") != std::string::npos ||
           line.find("smartKick(") != std::string::npos ||
           line.find("SmartKick(") != std::string::npos;
  });
  EXPECT_EQ(found, 1) << file;
}

// Adds lines below the first line of the change, which is in the file.
void add_lines(const std::vector<std::string>& change, const fs::path& file) {
  ASSERT_GT(change.size(), 1U);
  const int found =
      replace_line(change, file, [&](const std::string& line) { return line == change.front(); });
  EXPECT_EQ(found, 1) << file;
}

TEST_P(Languages, FirstChangeOfTheTutorialWins) {
  if (GetParam().name != "python" && !is_long_form()) {
    GTEST_SKIP() << GetParam().name << ": builds and plays twice: make languages";
  }
  const auto [file, change] = change_of(kFirstChapter, GetParam().name);
  ASSERT_FALSE(change.empty());

  const fs::path project = new_project("ada", "minimal");
  const Words match = {"ada", "mock", "--cycles", "1500", "--seed", "4", "--dir"};
  EXPECT_EQ(goals(project, joined(match, {"first"})), std::pair(0, 0));
  replace_kick(change, project / file);
  EXPECT_EQ(goals(project, joined(match, {"second"})), std::pair(2, 0));

  const CommandResult tested = run_in(project, {cls_binary(), "test", "tests/"}, environment());
  EXPECT_EQ(tested.exit_code, 0) << tested.out;
}

// The shell commands below a heading of a page.
std::vector<std::string> commands_of(const std::string& name, const std::string& heading) {
  std::istringstream page(read_file(source_folder() / name));
  std::vector<std::string> commands;
  bool below = false;
  bool shell = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) below = line == "## " + heading;
    if (line.starts_with("```")) {
      shell = line == "```sh";
    } else if (below && shell) {
      commands.push_back(line);
    }
  }
  return commands;
}

// The page as a reader follows it, each command twice: what it calls better is better.
TEST_P(Languages, TutorialEndsWithItsVerdict) {
  if (!is_long_form()) GTEST_SKIP() << "plays up to 40 half matches: make languages";
  const fs::path project = new_project("ada", "minimal");
  build(project);

  const Words keep = commands_of(kFirstChapter, "The first change that wins");
  ASSERT_EQ(keep.size(), 2U);
  for (const std::string& command : {keep[0], keep[0], keep[1], keep[1]}) {
    const CommandResult result = follow(project, command);
    EXPECT_EQ(result.exit_code, 0) << command << "\n" << result.out << result.err;
  }

  const auto [file, change] = change_of(kFirstChapter, GetParam().name);
  replace_kick(change, project / file);
  EXPECT_NE(read_file(project / file), read_file(folder_.path() / "old" / file));
  EXPECT_FALSE(fs::exists(folder_.path() / "old/runs"));

  const Words compare = commands_of(kFirstChapter, "Is it better?");
  ASSERT_EQ(compare.size(), 1U);
  const CommandResult verdict = follow(project, compare[0]);
  EXPECT_EQ(verdict.exit_code, 0) << verdict.out << verdict.err;
}

// What the page of the second chapter says of one half match: without its change, and with it.
TEST_P(Languages, SecondChapterConcedesLess) {
  if (GetParam().name != "python" && !is_long_form()) {
    GTEST_SKIP() << GetParam().name << ": builds and plays twice: make languages";
  }
  const auto [file, change] = change_of(kSecondChapter, GetParam().name);

  const fs::path project = new_project("grace", "team");
  const Words match = {"grace", "mock:planner", "--cycles", "3000", "--seed", "1", "--dir"};
  EXPECT_EQ(goals(project, joined(match, {"games/1"})), std::pair(0, 3));
  add_lines(change, project / file);
  EXPECT_EQ(goals(project, joined(match, {"after/1"})), std::pair(0, 1));
}

// The output that a page shows below a heading: the first block there without a language.
std::string shown_output(const std::string& name, const std::string& heading) {
  std::istringstream page(read_file(source_folder() / name));
  std::string output;
  bool below = false;
  enum { kText, kCode, kOutput } inside = kText;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) below = line == "## " + heading;
    if (!below) continue;

    if (line == "```" && inside == kOutput) return output;
    if (inside == kOutput) output += line + "\n";
    if (line == "```") {
      inside = inside == kText ? kOutput : kText;
    } else if (line.starts_with("```")) {
      inside = kCode;
    }
  }
  return "no output below " + heading;
}

// The page as a reader follows it from its first match on.
TEST_P(Languages, SecondChapterIsWhatItsReaderSees) {
  if (!is_long_form()) GTEST_SKIP() << "plays for minutes: make languages";
  const fs::path project = new_project("grace", "team");
  build(project);
  const auto output_below = [&](const std::string& heading, const std::string& begin) {
    std::string out;
    for (const std::string& command : commands_of(kSecondChapter, heading)) {
      if (!command.starts_with(begin)) continue;
      const CommandResult result = follow(project, command);
      EXPECT_EQ(result.exit_code, 0) << command << "\n" << result.out << result.err;
      out += result.out;
    }
    return out;
  };

  const auto shows = [&](const std::string& heading) {
    EXPECT_THAT(output_below(heading, "cls review"),
                HasSubstr(shown_output(kSecondChapter, heading)));
  };
  output_below("A team with rules of its own", "for seed");
  shows("Where does it lose?");
  shows("What would have been better?");

  output_below("The change", "[ -e");
  const auto [file, change] = change_of(kSecondChapter, GetParam().name);
  add_lines(change, project / file);
  output_below("Is it mended?", "for seed");
  shows("Is it mended?");
  output_below("A verdict", "cls book");
  output_below("A verdict", "cls compare");
}

INSTANTIATE_TEST_SUITE_P(Examples, Languages, testing::ValuesIn(languages()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace cls::tests
