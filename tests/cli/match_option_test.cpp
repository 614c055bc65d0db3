// A throw-away option of matches: one row, and it is everywhere.
#include "match/terms/option_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/application.h"
#include "match/result/match_folder.h"
#include "scenario/scenario_file.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tournament/config/config_file.h"
#include "tournament/store/match_attempt.h"

namespace cls {
namespace {

using match::AddedMatchOption;
using match::MatchOption;
using match::MatchOptions;
using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;

// Stored in a member that only resumed matches read.
MatchOption throw_away_option() {
  MatchOption option;
  option.key = "fan_noise";
  option.placeholder = "N";
  option.help = "decibels of the fans (default: 0)";
  option.form.kind = base::ValueKind::kWhole;
  option.form.min = 0;
  option.form.max = 140;
  option.set = [](MatchOptions& options, const std::string& text) -> base::Result<void> {
    options.branch_seed = std::stoull(text);
    return {};
  };
  option.shown = [](const MatchOptions& options) {
    return options.branch_seed ? std::to_string(*options.branch_seed) : std::string();
  };
  option.group = match::OptionGroup::kLimits;
  option.use = match::OptionUse::kConditions;
  option.example = "90";
  option.scenario_key = "fan_noise";
  return option;
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
  AddedMatchOption added_{throw_away_option()};
};

TEST_F(MatchOptionTable, RowIsInHelpCompletionAndManualPage) {
  const std::string help = run({"match", "--help"});
  EXPECT_THAT(help, HasSubstr("  --fan-noise N               decibels of the fans (default: 0)"));
  EXPECT_LT(help.find("Limits:"), help.find("--fan-noise"));
  EXPECT_THAT(run({"complete", "--", "match", "--fan"}), HasSubstr("--fan-noise\t"));
  run({"help", "--man", path("man").c_str()});
  EXPECT_THAT(tests::read_file(path("man/cls-match.1")), HasSubstr("\\-\\-fan\\-noise N"));
}

TEST_F(MatchOptionTable, RowHasItsErrors) {
  EXPECT_EQ(run({"match", "mock", "mock", "--fan-noise", "200"}, 2),
            "cls: --fan-noise '200': must be a whole number from 0 to 140\n");
}

TEST_F(MatchOptionTable, RowIsASettingWithItsOrigin) {
  std::ofstream(path("cls.toml")) << "[tournament]\nfan_noise = 90\n";
  const auto row_of = [&](std::vector<const char*> words) {
    words.insert(words.begin(), {"config", "mock", "mock", "--json"});
    const json document = json::parse(run(words));
    for (const json& row : document["settings"]) {
      if (row["name"] == "fan_noise") return row;
    }
    return json();
  };
  EXPECT_EQ(row_of({"--fan-noise", "80"})["value"], "80");
  EXPECT_EQ(row_of({"--fan-noise", "80"})["origin"], "option --fan-noise");
  const std::string file = path("cls.toml");
  EXPECT_EQ(row_of({"--config", file.c_str()})["value"], "90");
  EXPECT_THAT(row_of({"--config", file.c_str()})["origin"].get<std::string>(),
              HasSubstr("cls.toml:2"));
}

TEST_F(MatchOptionTable, RowIsInNewConfigurationsAndInTheMatchesOfTournaments) {
  run({"init", path("cup").c_str()});
  EXPECT_THAT(tests::read_file(path("cup/cls.toml")), HasSubstr("fan_noise = 90"));

  using namespace tournament;
  TournamentConfig config = parse_config(
                                "[tournament]\nfan_noise = 90\n[teams.A]\nendpoint = \"mock\"\n"
                                "[teams.B]\nendpoint = \"mock\"\n",
                                "cls.toml")
                                .config;
  Fixture fixture;
  fixture.left = 0;
  fixture.right = 1;
  EXPECT_THAT(match_plan(config, fixture, "cls", "").argv, IsSupersetOf({"--fan-noise", "90"}));
  EXPECT_THAT(format_config(config), HasSubstr("fan_noise = 90"));
  EXPECT_THAT(run({"tournament", "plan", "--help"}), HasSubstr("--fan-noise"));
}

TEST_F(MatchOptionTable, RowIsInScenarios) {
  const auto text = base::JsonDocument::parse(
      "noisy.json", R"({"fan_noise": 70, "expect": [{"end": "finished"}]})");
  ASSERT_TRUE(text);
  const auto scenario = scenario::parse_scenario(*text, {});
  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_EQ(scenario->options.at("fan_noise"), "70");
}

TEST_F(MatchOptionTable, RowIsInTheManifest) {
  MatchOptions options;
  options.branch_seed = 60;
  const json manifest = json::parse(match::manifest_json(options, {"a", "b"}, 1, {}));
  EXPECT_EQ(manifest["options"]["fan_noise"], "60");
}

}  // namespace
}  // namespace cls
