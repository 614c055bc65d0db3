// Output of the commands: --json, folding at 80 columns, color, and errors of files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/json.h"
#include "tests/support/pseudo_terminal.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

class CommandOutput : public testing::Test, public ClsFolder {
 protected:
  // A match of 20 cycles in the folder "m".
  void play() const {
    ASSERT_THAT(run({"match", "mock:hold", "mock:hold", "--cycles", "20", "--dir", "m"}), Exits(0));
  }
};

struct Document {
  Words words;
  std::string schema;
};

TEST_F(CommandOutput, JsonIsOneDocumentOfItsSchema) {
  play();
  write("cls.toml",
        "[tournament]\ncycles = 20\n[teams.A]\nendpoint = \"mock:hold\"\n"
        "[teams.B]\nendpoint = \"mock:hold\"\n");

  const std::vector<Document> documents = {
      {{"match", "mock:hold", "mock:hold", "--cycles", "20"}, "cls.match/1"},
      {{"match", "mock", "mock", "--dry-run"}, "cls.dry-run/1"},
      {{"tournament", "plan", "cup"}, "cls.tournament/1"},
      {{"tournament", "work", "cup", "--index", "1"}, "cls.work/1"},
      {{"tournament", "check-in", "cup"}, "cls.check-in/1"},
      {{"tournament", "run", "cup"}, "cls.tournament/1"},
      {{"tournament", "status", "cup"}, "cls.status/1"},
      {{"tournament", "report", "cup"}, "cls.tournament/1"},
      {{"tournament", "stop", "cup"}, "cls.stop/1"},
      {{"tournament", "decide", "cup"}, "cls.decisions/1"},
      {{"tournament", "decide", "cup", "--match", "1", "--annul", "--reason", "x"}, "cls.decide/1"},
      {{"test", "--list"}, "cls.scenarios/1"},
      {{"test", "--export", "scenarios"}, "cls.export/1"},
      {{"test", "referee_corner_kick"}, "cls.test/1"},
      {{"results", "m"}, "cls.results/1"},
      {{"stats", "m"}, "cls.stats/1"},
      {{"review", "m"}, "cls.review/1"},
      {{"convert", "m/match.rcg", "m/old.rcg", "--to", "4"}, "cls.convert/1"},
      {{"watch", "m", "--out", "m/page.html"}, "cls.watch/1"},
      {{"report", "m"}, "cls.report/1"},
      {{"check", "server-log", "m/match.rcg", "m/match.rcl"}, "cls.server-log/1"},
      {{"doctor"}, "cls.doctor/1"},
      {{"init", "new"}, "cls.init/1"},
      {{"new", "go", "ada"}, "cls.new/1"},
      {{"train", "spec"}, "cls.training.catalog/1"},
      {{"train", "spec", "ego"}, "cls.training.catalog/1"},
      {{"train", "spec", "cls/HFO-2v1-v0"}, "cls.training.catalog/1"},
      {{"completion", "bash"}, "cls.completion/1"},
      {{"help", "topics"}, "cls.topics/1"},
      {{"help", "testing"}, "cls.topic/1"},
      {{"version"}, "cls.version/1"},
  };

  for (const Document& document : documents) {
    Words words = document.words;
    words.emplace_back("--json");
    const CommandResult result = run(words);
    const json parsed = json::parse_or_discarded(result.out);
    ASSERT_FALSE(parsed.is_discarded()) << words[0] << ": " << result.out << result.err;
    EXPECT_EQ(parsed.value("schema", ""), document.schema) << words[0];
  }
}

TEST_F(CommandOutput, JsonOfConvertCountsFrames) {
  play();
  const json document = json::parse(run({"convert", "m/match.rcg", "new.json", "--json"}).out);
  EXPECT_EQ(document["out"], "new.json");
  EXPECT_EQ(document["version"], "json");
  EXPECT_GE(document["frames"], 20);
  EXPECT_EQ(document["errors"], 0);
  EXPECT_EQ(run({"convert", "m/match.rcg", "-", "--json"}).exit_code, 2);
}

TEST_F(CommandOutput, JsonOfRunningCommandsIsOneLineAtStart) {
  for (const std::string name : {"mock", "server"}) {
    Command command({cls_binary(), name, "--port", "0", "--json"}, {}, folder_.path());
    ASSERT_TRUE(command.wait_for_output("\n")) << name;
    const json line = json::parse(command.out());
    EXPECT_EQ(line["schema"], "cls." + name + "/1");
    EXPECT_EQ(line["host"], "127.0.0.1");
    EXPECT_GT(line["port"], 0);
    command.send_signal(SIGTERM);
    const CommandResult result = command.finish();
    EXPECT_EQ(result.out.find('\n'), result.out.size() - 1) << result.out;
    EXPECT_THAT(result.err, HasSubstr("listening on "));
  }
}

TEST_F(CommandOutput, DoctorFits80ColumnsWithoutBreakingWords) {
  const Words tight = {"PATH=/nonexistent"};
  const std::string text = run({"doctor", "--server", "embedded"}, tight).out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string last = line.substr(line.rfind(' ') + 1);
    EXPECT_TRUE(line.size() <= 80 || line.size() == 28 + last.size()) << line;
  }
  EXPECT_THAT(text, HasSubstr("hint: "));
}

// A terminal of 40 columns: no line is longer, but for the path of a command.
TEST_F(CommandOutput, NarrowTerminalsFoldMatchAndDoctor) {
  const auto lines_of = [this](const std::string& command) {
    PseudoTerminal terminal({"/bin/sh", "-c", "stty cols 40; " + command + "; echo the end"},
                            {"TERM=xterm", "NO_COLOR=1"}, folder_.path());
    EXPECT_TRUE(terminal.wait_for("the end", std::chrono::seconds(60)));
    std::string shown = terminal.shown();
    std::erase(shown, '\r');
    std::vector<std::string> lines;
    std::istringstream in(shown);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
  };

  for (const std::string command : {"match mock:hold mock:hold --cycles 20 --quiet", "doctor"}) {
    const auto lines = lines_of(cls_binary().string() + " " + command);
    EXPECT_GT(lines.size(), 10U) << command;
    for (const std::string& line : lines) {
      const std::size_t word = line.rfind(' ') == std::string::npos ? 0 : line.rfind(' ') + 1;
      EXPECT_TRUE(line.size() <= 40 || word <= std::string("  cls watch ").size()) << line;
    }
  }
}

TEST_F(CommandOutput, QuietDoctorPrintsOnlyWhatIsNotOk) {
  const std::string text = run({"doctor", "--quiet"}, {"PATH=/nonexistent"}).out;
  EXPECT_THAT(text, Not(HasSubstr("ok ")));
  EXPECT_THAT(text, HasSubstr("missing "));
}

TEST_F(CommandOutput, ColorFollowsOptionAndEnvironment) {
  const Words words = {"doctor"};
  const auto colored = [&](const Words& arguments, const Words& environment) {
    return run(arguments, environment).out.find("\x1b[") != std::string::npos;
  };
  EXPECT_FALSE(colored(words, {}));
  EXPECT_TRUE(colored(words, {"CLICOLOR_FORCE=1"}));
  EXPECT_FALSE(colored(words, {"CLICOLOR_FORCE=1", "NO_COLOR=1"}));
  EXPECT_FALSE(colored({"--no-color", "doctor"}, {"CLICOLOR_FORCE=1"}));
  EXPECT_FALSE(colored({"doctor", "--no-color"}, {"CLICOLOR_FORCE=1"}));
}

TEST_F(CommandOutput, FileErrorsNameWhatTheUserTypedAndTheCause) {
  write("plain", "");
  EXPECT_EQ(run({"init", "plain/cup"}).err, "cls: cannot create 'plain/cup': Not a directory\n");
  EXPECT_EQ(run({"test", "--export", "plain/out"}).err,
            "cls: cannot create 'plain/out': Not a directory\n");
  EXPECT_EQ(run({"match", "mock", "mock", "--formation", "nowhere"}).err,
            "cls: --formation: nowhere: no such folder\n");
  EXPECT_EQ(run({"match", "mock", "mock", "--formation", "plain"}).err,
            "cls: --formation: plain: a file, not a folder\n");
}

TEST_F(CommandOutput, FileErrorsTellFoldersFromFiles) {
  write("plain", "");
  EXPECT_EQ(run({"match", "mock", "mock", "--config", "."}).err,
            "cls: --config .: a folder, not a file\n");
  EXPECT_EQ(run({"match", "RED", "mock", "--config", "."}).err, "cls: .: a folder, not a file\n");
  EXPECT_EQ(run({"tournament", "plan", "cup", "--config", "."}).err,
            "cls: .: a folder, not a file\n");
  EXPECT_EQ(run({"match", "team:plain", "mock"}).err,
            "cls: team folder plain: a file, not a folder\n");
  EXPECT_EQ(run({"logs", "plain"}).err, "cls: plain: a file, not a folder\n");
}

// A name that the file system refuses is not an internal error.
TEST_F(CommandOutput, FileErrorsNameTheCauseOfAnUnusablePath) {
  const std::string name = std::string(300, 'x') + ".json";
  for (const Words& words :
       {Words{"mock", name}, Words{"test", name}, Words{"test", "--replay", name, "mock"},
        Words{"match", "mock", "mock:" + name}}) {
    EXPECT_THAT(run(words),
                Exits(66, testing::AllOf(Not(HasSubstr("internal error")), HasSubstr(name))));
  }
  std::filesystem::create_directory(folder_.path() / "folder");
  const CommandResult tls = run({"match", "mock", "tls:localhost:1", "--tls-ca", "folder"});
  EXPECT_EQ(tls.exit_code, 66);
  EXPECT_EQ(tls.err, "cls: --tls-ca: folder: cannot read\n");
  EXPECT_EQ(run({"check", "playmaker", "mock:none.json"}).exit_code, 66);
  write("plain", "");
  EXPECT_THAT(run({"test", "--replay", "plain", "run:true {port}", "--dir", "plain/runs"}),
              Exits(73, "cls: cannot create 'plain/runs': Not a directory\n"));
}

TEST_F(CommandOutput, MatchesOfATournamentHaveTheFormInErrors) {
  const Words words = {"tournament", "plan",   "cup",    "--format", "list",
                       "--team",     "A=mock", "--team", "B=mock",   "--matches"};
  Words good = words;
  good.emplace_back("A:B");
  EXPECT_EQ(run(good).exit_code, 0) << run(good).err;
  Words huge = good;
  huge.insert(huge.end(), {"--seed", "99999999999999999999999"});
  EXPECT_EQ(run(huge).err, "cls: --seed 99999999999999999999999: must be a whole number from 0\n");
  Words bad = words;
  bad.emplace_back("A-B");
  EXPECT_EQ(run(bad).err,
            "cls: --matches A-B: 'A-B' is not a pairing of two teams, as A:B in --matches "
            "A:B,C:D or [\"A\", \"B\"] in cls.toml\n");
}

}  // namespace
}  // namespace cls::tests
