// Parsing of scenario files and their errors.
#include "scenario/scenario_file.h"

#include <gtest/gtest.h>

#include "base/text/json.h"
#include "scenario/scenario_library.h"

namespace cls::scenario {
namespace {

using base::Json;
using base::JsonDocument;
using soccer::PlayMode;

base::Result<Scenario> parse(const std::string& text) {
  const auto json = JsonDocument::parse("a/corner.json", text);
  EXPECT_TRUE(json) << json.error().message;
  return parse_scenario(*json, Json());
}

std::string error(const std::string& text) {
  const auto scenario = parse(text);
  return scenario ? "" : scenario.error().message;
}

TEST(ScenarioFile, ReadsInitialSituation) {
  const auto scenario = parse(R"({
    "seeds": 3, "noise": false, "server": {"half_time": 20, "penalty_shoot_outs": true},
    "mode": "corner_kick_l", "cycle": 70, "score": [1, 2],
    "ball": {"at": [52, 33], "velocity": [0, -1]},
    "left": {"playmaker": "mock:hold",
             "players": {"9": {"at": [40, 1], "body": 90, "stamina": 3000}}},
    "right": {"playmaker": {"otherwise": "simple"}},
    "under_test": "left", "steps": 40, "until": {"mode": "goal_l"},
    "expect": [{"score": [2, 2]}]})");

  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_EQ(scenario->name, "corner");
  EXPECT_EQ(scenario->seeds, (std::vector<std::uint64_t>{1, 2, 3}));
  EXPECT_EQ(scenario->server.half_time, 20);
  EXPECT_TRUE(scenario->server.penalty_shoot_outs);
  EXPECT_EQ(scenario->server.ball_rand, 0.0);
  EXPECT_EQ(scenario->mode, PlayMode::kCornerKickLeft);
  EXPECT_EQ(scenario->cycle, 70);
  EXPECT_EQ(scenario->score[1], 2);
  EXPECT_EQ(scenario->ball.y, 33.0);
  EXPECT_EQ(scenario->ball_velocity.y, -1.0);
  EXPECT_EQ(scenario->sides[0].playmaker.behavior, "hold");
  EXPECT_EQ(scenario->sides[0].players.at(9).body, 90.0);
  EXPECT_EQ(scenario->sides[0].players.at(9).stamina, 3000.0);
  EXPECT_TRUE(scenario->sides[1].players.empty());
  EXPECT_NE(scenario->sides[1].playmaker.script, nullptr);
  EXPECT_EQ(scenario->under_test, soccer::Side::kLeft);
  EXPECT_EQ(scenario->steps, 40);
  EXPECT_EQ(scenario->until.size(), 1u);
  EXPECT_EQ(scenario->checks.size(), 4u)
      << "one explicit; end reason and missed decisions of both sides are implicit";
}

TEST(ScenarioFile, ErrorsNameLineLocationAndSuggestion) {
  const std::string end = R"(, "expect": [{"score": [0, 0]}]})";
  EXPECT_EQ(error("{\n\"stepps\": 3" + end),
            "a/corner.json:2: /stepps: unknown key 'stepps'; did you mean 'steps'?");
  EXPECT_EQ(error("{\"mode\": \"corner_kick_left\"" + end),
            "a/corner.json:1: /mode: unknown 'corner_kick_left'; did you mean 'corner_kick_l'?");
  EXPECT_EQ(error("{\"server\": {\"half_tme\": 3}" + end),
            "a/corner.json:1: /server/half_tme: unknown parameter 'half_tme'; did you mean "
            "'half_time'?");
  EXPECT_EQ(error("{\"left\": {\"players\": {\"12\": {\"at\": [0, 0]}}}" + end),
            "a/corner.json:1: /left/players/12: '12' is not a uniform number");
  EXPECT_EQ(error("{\"left\": {\"playmaker\": \"mock:hodl\"}" + end),
            "a/corner.json:1: /left/playmaker: unknown mock behavior 'hodl'; did you mean 'hold'?");
  EXPECT_EQ(error("{\"steps\": 3}"), "a/corner.json:1: requires \"expect\": a list of checks");
}

TEST(ScenarioFile, ReportsErrorsOfChecks) {
  const auto check = [](const std::string& text) { return error("{\"expect\": [" + text + "]}"); };
  EXPECT_EQ(check(R"({"scroe": [0, 0]})"),
            "a/corner.json:1: /expect/0: unknown kind of check 'scroe'; did you mean 'score'?");
  EXPECT_EQ(check(R"({"ball": {"in": "left_gaol"}})"),
            "a/corner.json:1: /expect/0/ball/in: unknown 'left_gaol'; did you mean 'left_goal'?");
  EXPECT_EQ(check(R"({"player": "lft 9", "is": {"x": 1}})"),
            "a/corner.json:1: /expect/0/player: 'lft 9' is not a player; use the form \"left 9\"");
  EXPECT_EQ(check(R"({"ball": {"x": 1}, "at": 200})"),
            "a/corner.json:1: /expect/0/at: 200 is not within 0 to 100");
  EXPECT_EQ(check(R"({"actions": "body_smart_kik", "side": "left"})"),
            "a/corner.json:1: /expect/0/actions: unknown 'body_smart_kik'; did you mean "
            "'body_smart_kick'?");

  EXPECT_EQ(check(R"({"referee": "ofside_l", "count": 0})"),
            "a/corner.json:1: /expect/0/referee: unknown referee message 'ofside_l'; did you mean "
            "'offside_l'?");
  EXPECT_EQ(check(R"({"referee": "goal_l"})"),
            "a/corner.json:1: /expect/0/referee: unknown referee message 'goal_l'; did you mean "
            "'foul_l'?");
  EXPECT_EQ(check(R"({"referee": "yellow_card_l_11"}, {"referee": "goal_r_12"})"), "");
  EXPECT_EQ(check(R"({"referee": "yellow_card_l_12"})").substr(0, 72),
            "a/corner.json:1: /expect/0/referee: unknown referee message 'yellow_card");
  EXPECT_EQ(check(R"({"actions": "dash"})"), "a/corner.json:1: /expect/0: requires \"side\"");
  EXPECT_EQ(check(R"({"ball": {"near": [0, 0]}})"),
            "a/corner.json:1: /expect/0/ball: \"near\" requires \"within\", in meters");
}

TEST(ScenarioFile, ResolvesFolderOfExternalTeam) {
  const std::string side = R"({"right": {"playmaker": "team:helios"}, "expect": [)";
  const auto scenario = parse(side + R"({"score": [0, 0]}, {"missed": 0, "side": "right"}]})");

  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_EQ(scenario->sides[1].playmaker.path, "a/helios");

  for (const char* check :
       {R"({"actions": "*", "side": "right"})", R"({"commands": "dash", "side": "right"})",
        R"({"rpc": "Register", "side": "right", "count": 11})",
        R"({"latency_ms": {"p99": 1}, "side": "right"})"}) {
    EXPECT_EQ(error(side + check + "]}")
                  .rfind("a/corner.json:1: /expect/0: an external team has no Playmaker: ", 0),
              0u)
        << check;
    EXPECT_EQ(
        error("{\"left\": {\"playmaker\": \"team:x\"}, \"expect\": [" + std::string(check) + "]}"),
        "");
  }
}

TEST(ScenarioLibrary, ReadsAllShippedScenarios) {
  const auto scenarios = shipped_scenarios();
  ASSERT_TRUE(scenarios) << scenarios.error().message;
  EXPECT_GE(scenarios->size(), 30u);
  for (const Scenario& scenario : *scenarios) EXPECT_FALSE(scenario.about.empty()) << scenario.name;
}

}  // namespace
}  // namespace cls::scenario
