// Scripts: rule selection and error messages.
#include "mock-server/script/script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mock-server/mock.h"
#include "mock-server/script/named_behaviors.h"

namespace cls::mock_server {
namespace {

using testing::HasSubstr;

std::shared_ptr<const Script> script(const std::string& text) {
  const base::JsonDocument json = *base::JsonDocument::parse("s.json", text);
  auto parsed = parse_script(base::JsonValue(json));
  EXPECT_TRUE(parsed) << parsed.error().message;
  return parsed ? *parsed : nullptr;
}

std::string error(const std::string& text) {
  const base::JsonDocument json = *base::JsonDocument::parse("s.json", text);
  const auto parsed = parse_script(base::JsonValue(json));
  return parsed ? "" : parsed.error().message;
}

protos::State state(int unum, int cycle, protos::GameModeType mode = protos::PlayOn) {
  protos::State state;
  state.mutable_register_response()->set_uniform_number(unum);
  state.mutable_world_model()->set_cycle(cycle);
  state.mutable_world_model()->set_game_mode_type(mode);
  return state;
}

std::string first_action(const std::string& rules, const protos::State& asked) {
  const ScriptedBehavior behavior(script(rules));
  protos::PlayerActions actions;
  behavior.decide(asked, actions);
  return actions.actions_size() == 0 ? "" : actions.actions(0).ShortDebugString();
}

TEST(Script, FirstMatchingRuleDecides) {
  const std::string rules = R"({"rules": [
      {"when": {"unum": 9, "cycle": [10, 19]}, "reply": [{"kick": {"power": 80}}]},
      {"when": {"unum": [9, 10]}, "reply": {"actions": [{"dash": {"power": 100}}]}},
      {"when": {"mode": ["KickOff", "FreeKick_"]}, "reply": [{"bodyTurnToBall": {"cycle": 1}}]},
      {"when": {"state": {"ball.position.x": {">": 5}}}, "reply": [{"catch": {}}]},
      {"when": {"cycle": {"from": 100, "every": 10}}, "reply": []},
      {"reply": [{"say": {"wait_request_message": {}}}]}]})";

  EXPECT_EQ(first_action(rules, state(9, 10)), "kick { power: 80 }");
  EXPECT_EQ(first_action(rules, state(9, 20)), "dash { power: 100 }");
  EXPECT_EQ(first_action(rules, state(10, 15)), "dash { power: 100 }");
  EXPECT_EQ(first_action(rules, state(2, 15, protos::FreeKick_)), "body_turn_to_ball { cycle: 1 }");
  EXPECT_EQ(first_action(rules, state(2, 15)), "say { wait_request_message { } }");
  EXPECT_EQ(first_action(rules, state(2, 110)), "");
  EXPECT_EQ(first_action(rules, state(2, 111)), "say { wait_request_message { } }");

  protos::State near_goal = state(2, 15);
  near_goal.mutable_world_model()->mutable_ball()->mutable_position()->set_x(6.0F);

  EXPECT_EQ(first_action(rules, near_goal), "catch { }");
}

TEST(Script, UsesBehaviorByName) {
  const ScriptedBehavior scripted(
      script(R"({"rules": [{"when": {"unum": 1}, "reply": "hold"}], "otherwise": "random:3"})"));
  const auto compare = [&](const char* name, const protos::State& asked) {
    protos::PlayerActions expected;
    (*make_behavior(name))->decide(asked, expected);
    protos::PlayerActions actual;
    scripted.decide(asked, actual);
    EXPECT_EQ(actual.ShortDebugString(), expected.ShortDebugString()) << name;
  };
  compare("hold", state(1, 7));
  compare("random:3", state(2, 7));
}

TEST(Script, SupportsRulesForCoachAndTrainer) {
  const ScriptedBehavior behavior(script(R"({"rules": [
      {"rpc": "GetCoachActions",
       "reply": [{"change_player_types": {"uniform_number": 2, "type": 5}}]},
      {"rpc": "GetTrainerActions", "when": {"cycle": 3},
       "reply": [{"do_change_mode": {"game_mode_type": "PlayOn", "side": "LEFT"}}]}]})"));
  protos::CoachActions coach;
  behavior.decide_as_coach(state(12, 1), coach);

  EXPECT_EQ(coach.actions(0).change_player_types().type(), 5);
  protos::TrainerActions trainer;
  behavior.decide_as_trainer(state(13, 3), trainer);

  EXPECT_EQ(trainer.actions(0).do_change_mode().game_mode_type(), protos::PlayOn);
  protos::TrainerActions nothing;
  behavior.decide_as_trainer(state(13, 4), nothing);
  EXPECT_EQ(nothing.actions_size(), 0);
}

TEST(Script, ReportsErrorsWithLocationAndSuggestion) {
  EXPECT_EQ(error("{\"ruls\": []}"), "s.json:1: /ruls: unknown key 'ruls'; did you mean 'rules'?");
  EXPECT_EQ(error("{\"rules\": [\n{\"reply\": [{\"dsah\": {}}]}]}"),
            "s.json:2: /rules/0/reply/0/dsah: PlayerAction has no field 'dsah'; did you mean "
            "'dash'?");
  EXPECT_EQ(error(R"({"rules": [{"reply": [{"dash": {"pwer": 1}}]}]})"),
            "s.json:1: /rules/0/reply/0/dash/pwer: Dash has no field 'pwer'; did you mean "
            "'power'?");
  EXPECT_EQ(error(R"({"rules": [{"when": {"mode": "Playon"}, "reply": []}]})"),
            "s.json:1: /rules/0/when/mode: unknown 'Playon'; did you mean 'PlayOn'?");
  EXPECT_EQ(error(R"({"rules": [{"when": {"unum": 14}, "reply": []}]})"),
            "s.json:1: /rules/0/when/unum: 14 is not a uniform number (1 to 11, 12 coach, 13 "
            "trainer)");
  EXPECT_EQ(error(R"({"rules": [{"when": {}}]})"), "s.json:1: /rules/0: needs \"reply\"");
  EXPECT_EQ(error(R"({"rules": [{"reply": "smple"}]})"),
            "s.json:1: /rules/0/reply: unknown mock behavior 'smple'; did you mean 'simple'?");
  EXPECT_THAT(error(R"({"rules": [{"reply": [{"dash": {"power": "fast"}}]}]})"), HasSubstr("fast"));
}

TEST(RandomBehavior, DependsOnlyOnSeedUnumAndCycle) {
  const auto reply = [](const char* name, int unum, int cycle) {
    protos::PlayerActions actions;
    (*make_behavior(name))->decide(state(unum, cycle), actions);
    return actions.SerializeAsString();
  };
  EXPECT_EQ(reply("random:4", 5, 100), reply("random:4", 5, 100));
  EXPECT_NE(reply("random:4", 5, 100), reply("random:5", 5, 100));
  EXPECT_NE(reply("random:4", 5, 100), reply("random:4", 6, 100));
  EXPECT_NE(reply("random:4", 5, 100), reply("random:4", 5, 101));
}

TEST(RandomBehavior, UsesEveryAction) {
  std::set<int> seen;
  const auto behavior = make_behavior("random");
  for (int cycle = 0; cycle < 1000; ++cycle) {
    protos::PlayerActions actions;
    (*behavior)->decide(state(7, cycle), actions);
    for (const auto& action : actions.actions()) seen.insert(action.action_case());
  }
  EXPECT_EQ(seen.size(), 69u);
}

}  // namespace
}  // namespace cls::mock_server
