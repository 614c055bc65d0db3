// Conditions on the fields of a State.
#include "mock-server/script/field_path.h"

#include <gtest/gtest.h>

#include "proto/playmaker.pb.h"

namespace cls::mock_server {
namespace {

protos::State state() {
  protos::State state;
  protos::WorldModel& world = *state.mutable_world_model();
  world.set_cycle(42);
  world.set_game_mode_type(protos::KickIn_);
  world.mutable_self()->set_stamina(7000.0F);
  world.mutable_self()->set_is_kickable(true);
  world.mutable_ball()->mutable_position()->set_x(12.5F);
  world.set_our_team_name("Reds");

  for (const int unum : {3, 9}) {
    protos::Player& teammate = *world.add_teammates();
    teammate.set_uniform_number(unum);
    teammate.mutable_position()->set_x(static_cast<float>(unum));
    (*world.mutable_our_players_dict())[unum] = teammate;
  }

  return state;
}

bool holds(const std::string& conditions) {
  const base::JsonDocument text = *base::JsonDocument::parse("test", conditions);
  const auto parsed = parse_conditions(*protos::State::descriptor(), base::JsonValue(text));
  EXPECT_TRUE(parsed) << parsed.error().message;
  if (!parsed) return false;
  for (const Condition& condition : *parsed) {
    if (!condition.holds(state())) return false;
  }
  return true;
}

std::string error(const std::string& conditions) {
  const base::JsonDocument text = *base::JsonDocument::parse("test", conditions);
  const auto parsed = parse_conditions(*protos::State::descriptor(), base::JsonValue(text));
  return parsed ? "" : parsed.error().message;
}

TEST(FieldPath, ComparesScalars) {
  EXPECT_TRUE(holds(R"({"world_model.cycle": 42})"));
  EXPECT_FALSE(holds(R"({"world_model.cycle": 41})"));
  EXPECT_TRUE(holds(R"({"cycle": {">": 41, "<=": 42}})"));
  EXPECT_FALSE(holds(R"({"cycle": {">": 42}})"));
  EXPECT_FALSE(holds(R"({"cycle": {"<": 42}})"));
  EXPECT_TRUE(holds(R"({"cycle": {"in": [1, 42]}})"));
  EXPECT_FALSE(holds(R"({"cycle": {"in": [1, 2]}})"));
  EXPECT_TRUE(holds(R"({"cycle": {"between": [42, 50]}})"));
  EXPECT_FALSE(holds(R"({"cycle": {"between": [43, 50]}})"));
  EXPECT_TRUE(holds(R"({"cycle": {"!=": 3}})"));
  EXPECT_TRUE(holds(R"({"self.is_kickable": true, "ourTeamName": "Reds"})"));
  EXPECT_FALSE(holds(R"({"self.is_kickable": false})"));
  EXPECT_TRUE(holds(R"({"ball.position.x": {">=": 12.5}})"));
}

TEST(FieldPath, UnsetFieldsHaveDefaultValue) {
  EXPECT_TRUE(holds(R"({"intercept_table.self_reach_steps": 0})"));
  EXPECT_TRUE(holds(R"({"need_preprocess": false})"));
}

TEST(FieldPath, ComparesEnumsByName) {
  EXPECT_TRUE(holds(R"({"game_mode_type": "KickIn_"})"));
  EXPECT_TRUE(holds(R"({"game_mode_type": "KickIn"})"));
  EXPECT_FALSE(holds(R"({"game_mode_type": "PlayOn"})"));
}

TEST(FieldPath, SelectsElementsOfListsAndMaps) {
  EXPECT_TRUE(holds(R"({"teammates.size": 2})"));
  EXPECT_TRUE(holds(R"({"teammates.1.uniform_number": 9})"));
  EXPECT_FALSE(holds(R"({"teammates.2.uniform_number": 9})"));
  EXPECT_TRUE(holds(R"({"teammates.*.uniform_number": 9})"));
  EXPECT_FALSE(holds(R"({"teammates.*.uniform_number": 8})"));
  EXPECT_TRUE(holds(R"({"our_players_dict.3.position.x": 3})"));
  EXPECT_FALSE(holds(R"({"our_players_dict.4.position.x": 0})"));
  EXPECT_TRUE(holds(R"({"our_players_dict.4": {"present": false}})"));
  EXPECT_TRUE(holds(R"({"our_players_dict.9": {"present": true}})"));
}

TEST(FieldPath, TestsPresenceOfMessages) {
  EXPECT_TRUE(holds(R"({"full_world_model": {"present": false}})"));
  EXPECT_TRUE(holds(R"({"self": {"present": true}})"));
  EXPECT_FALSE(holds(R"({"penalty_kick_state": {"present": true}})"));
}

TEST(FieldPath, ReportsErrorsWithLocation) {
  EXPECT_EQ(error(R"({"self.stamna": 1})"),
            "test:1: /self.stamna: Self has no field 'stamna'; did you mean 'stamina'?");
  EXPECT_EQ(error(R"({"cycle.x": 1})"), "test:1: /cycle.x: 'cycle' has no fields");
  EXPECT_EQ(error(R"({"teammates.first": 1})"),
            "test:1: /teammates.first: after 'teammates' comes an index from 0, '*' or 'size', not "
            "'first'");
  EXPECT_EQ(error(R"({"cycle": "one"})"), "test:1: /cycle: must be a number, not \"one\"");
  EXPECT_EQ(error(R"({"cycle": {"=>": 1}})"),
            "test:1: /cycle/=>: unknown operator '=>' (known: == != < <= > >= in between)");
  EXPECT_EQ(error(R"({"game_mode_type": "PlayOm"})"),
            "test:1: /game_mode_type: GameModeType has no value 'PlayOm'; did you mean 'PlayOn'?");
  EXPECT_EQ(error(R"({"self.is_kickable": {"<": true}})"),
            "test:1: /self.is_kickable/<: '<' is for numbers");
  EXPECT_EQ(error(R"({"ball": 3})"),
            "test:1: /ball: a message cannot be compared; use {\"present\": true}");
}

TEST(FieldPath, ViolationNamesActualValue) {
  const base::JsonDocument text =
      *base::JsonDocument::parse("test", R"({"teammates.*.uniform_number": {">": 9}})");
  const auto parsed = parse_conditions(*protos::State::descriptor(), base::JsonValue(text));
  EXPECT_EQ(parsed->front().complaint(state()), "teammates.*.uniform_number is 3, 9, not > 9");
}

}  // namespace
}  // namespace cls::mock_server
