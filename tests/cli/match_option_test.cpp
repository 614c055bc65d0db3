// Options of matches: a row of their table is everywhere.
#include "match/terms/option_table.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "base/text/replace_all.h"
#include "cli/application.h"
#include "match/result/match_folder.h"
#include "scenario/scenario_file.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"
#include "tournament/config/config_file.h"
#include "tournament/store/match_attempt.h"

namespace cls {
namespace {

using match::MatchOption;
using match::MatchOptions;
using json = base::Json;
using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

// "--coach,--no-coach", "--cycles N": an option in help.
std::string in_help(const MatchOption& row) {
  std::string text = match::option_name(row.key);
  if (row.has_opposite) text += "," + match::option_name("no_" + std::string(row.key));
  return row.placeholder.empty() ? text : fmt::format("{} {}", text, row.placeholder);
}

class MatchOptionTable : public testing::Test {
 protected:
  // The output of a command.
  std::string run(std::vector<const char*> words, int expected_exit_code = 0) {
    words.insert(words.begin(), "cls");
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int exit_code =
        cli::run_application(*cli::command_tree(), static_cast<int>(words.size()), words.data());
    std::fflush(stdout);
    std::fflush(stderr);
    const std::string out = testing::internal::GetCapturedStdout();
    const std::string err = testing::internal::GetCapturedStderr();
    EXPECT_EQ(exit_code, expected_exit_code) << err;
    return out + err;
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  tests::TemporaryFolder folder_;
};

TEST_F(MatchOptionTable, RowsAreInHelpCompletionAndManualPage) {
  const std::string help = run({"match", "--help"});
  const std::string completed = run({"complete", "--", "match", "--"});
  run({"help", "--man", path("man").c_str()});
  const std::string manual = tests::read_file(path("man/cls-match.1"));
  for (const MatchOption& row : match::match_options()) {
    EXPECT_THAT(help, HasSubstr("  " + in_help(row)));
    EXPECT_THAT(completed, HasSubstr(match::option_name(row.key) + "\t"));
    std::string in_manual = in_help(row);
    base::replace_all(in_manual, "-", "\\-");
    EXPECT_THAT(manual, HasSubstr(in_manual));
  }
  EXPECT_LT(help.find("Limits:"), help.find("--max-memory"));
  EXPECT_LT(help.find("--max-memory"), help.find("Debugging:"));
}

TEST_F(MatchOptionTable, RowHasItsErrors) {
  EXPECT_EQ(run({"match", "mock", "mock", "--monitor-port", "70000"}, 2),
            "cls: --monitor-port '70000': must be a whole number from 0 to 65535\n");
}

TEST_F(MatchOptionTable, RowIsASettingWithItsOrigin) {
  std::ofstream(path("cls.toml")) << "[tournament]\nadjudicate = 9\n";
  const auto row_of = [&](std::vector<const char*> words) {
    words.insert(words.begin(), {"config", "mock", "mock", "--json"});
    const json document = json::parse(run(words));
    for (const json& row : document["settings"]) {
      if (row["name"] == "adjudicate") return row;
    }
    return json();
  };

  EXPECT_EQ(row_of({"--adjudicate", "8"})["value"], "8");
  EXPECT_EQ(row_of({"--adjudicate", "8"})["origin"], "option --adjudicate");

  const std::string file = path("cls.toml");
  EXPECT_EQ(row_of({"--config", file.c_str()})["value"], "9");
  EXPECT_THAT(row_of({"--config", file.c_str()})["origin"].get<std::string>(),
              HasSubstr("cls.toml:2"));
}

TEST_F(MatchOptionTable, RowsAreInNewConfigurationsAndInTheOptionsOfTournaments) {
  run({"init", path("cup").c_str()});
  const std::string written = tests::read_file(path("cup/cls.toml"));
  const std::string help = run({"tournament", "run", "--help"});
  for (const MatchOption& row : match::match_options()) {
    if (row.use == match::OptionUse::kOneMatch) continue;
    EXPECT_THAT(written, HasSubstr(fmt::format("{} = {}\n", row.key, row.example)));
    EXPECT_THAT(help,
                HasSubstr(fmt::format("  {} {}", match::option_name(row.key),
                                      row.placeholder.empty() ? "true|false" : row.placeholder)));
  }
}

TEST_F(MatchOptionTable, OptionsOfTournamentsNameTheirValues) {
  for (const std::vector<const char*>& words :
       {std::vector{"tournament", "run", "--help"}, std::vector{"tournament", "plan", "--help"},
        std::vector{"compare", "--help"}, std::vector{"tune", "run", "--help"}}) {
    EXPECT_THAT(run(words), Not(HasSubstr(" VALUE")));
  }
  EXPECT_THAT(run({"tournament", "run", "--help"}),
              AllOf(HasSubstr("--remote-folder DIR"), HasSubstr("--pin true|false"),
                    HasSubstr("--matches A:B,..."), HasSubstr("--half-time N")));
}

TEST_F(MatchOptionTable, RowIsInTheMatchesOfTournaments) {
  using namespace tournament;
  const TournamentConfig config = parse_config(
                                      "[tournament]\nadjudicate = 9\n[teams.A]\n"
                                      "endpoint = \"mock\"\n[teams.B]\nendpoint = \"mock\"\n",
                                      "cls.toml")
                                      .config;
  Fixture fixture;
  fixture.left = 0;
  fixture.right = 1;
  EXPECT_THAT(match_plan(config, fixture, "cls", "").argv, IsSupersetOf({"--adjudicate", "9"}));
  EXPECT_THAT(format_config(config), HasSubstr("adjudicate = 9"));
}

TEST_F(MatchOptionTable, RowsAreInScenarios) {
  const auto text = base::JsonDocument::parse("late.json", R"({
      "rpc_deadline_ms": 70, "on_late": "last", "batch": "never", "max_missed": 7, "coach": false,
      "expect": [{"end": "finished"}]})");
  ASSERT_TRUE(text);
  const auto scenario = scenario::parse_scenario(*text, {});
  ASSERT_TRUE(scenario) << scenario.error().message;
  using Entry = std::pair<const std::string, std::string>;
  EXPECT_THAT(scenario->options, IsSupersetOf({Entry("rpc_deadline", "70"),
                                               Entry("on_late", "last"), Entry("batch", "never"),
                                               Entry("max_missed", "7"), Entry("coach", "false")}));
}

TEST_F(MatchOptionTable, RowIsInTheManifest) {
  MatchOptions options;
  options.max_missed = 60;
  const json manifest = json::parse(match::manifest_json(options, {"a", "b"}, 1, {}));
  EXPECT_EQ(manifest["options"]["max_missed"], "60");
}

}  // namespace
}  // namespace cls
