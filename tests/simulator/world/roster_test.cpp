// Connecting, disconnecting, player types, stamina, parameters.
#include "simulator/world/roster.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "simulator/referee/substitution.h"
#include "simulator/world/stamina.h"
#include "tests/simulator/stage.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using namespace cls::simulator;
using Roster = OnStage;
using Stamina = OnStage;
using Trainer = OnStage;

TEST_F(Roster, AssignsUniformNumbersInOrderOfConnection) {
  World world = make_match({});
  EXPECT_EQ(join(world, Side::kLeft, false, 18), slot_of(Side::kLeft, 1));
  EXPECT_EQ(join(world, Side::kRight, true, 18), slot_of(Side::kRight, 1));
  EXPECT_EQ(join(world, Side::kLeft, true, 14), slot_of(Side::kLeft, 2));
  EXPECT_FALSE(join(world, Side::kLeft, true, 14).has_value()) << "one goalie per team";
  const Player& goalie = world.player(Side::kLeft, 2);
  expect_near(goalie.position, {-6, -37});
  EXPECT_EQ(goalie.state, state::kStand | state::kGoalie);
  EXPECT_FALSE(goalie.view.synchronous);
  EXPECT_TRUE(world.player(Side::kLeft, 1).view.synchronous);
  for (int i = 3; i <= 11; ++i) EXPECT_TRUE(join(world, Side::kLeft, false, 18).has_value());
  EXPECT_FALSE(join(world, Side::kLeft, false, 18).has_value()) << "eleven players per team";
}

TEST_F(Roster, TurnsRightPlayersToZeroInFirstStep) {
  World world = make_match({});
  const Slot slot = *join(world, Side::kRight, false, 18);
  EXPECT_DOUBLE_EQ(world.player(slot).body, soccer::math::kPi);
  Events events;
  step(world, events);
  EXPECT_DOUBLE_EQ(world.player(slot).body, 0.0);
}

TEST_F(Roster, AllowsPlayersToLeaveAndReconnect) {
  Player& player = stage.add(Side::kLeft, {0, 0});
  player.counters.kick = 4;
  player.stamina.value = 5000;
  player.state |= state::kYellowCard;
  leave(stage.world, player.slot());
  EXPECT_FALSE(player.enabled);
  EXPECT_EQ(player.state, state::kYellowCard);
  stage.step();
  EXPECT_EQ(player.stamina.value, 5000);
  rejoin(stage.world, player.slot());
  EXPECT_EQ(player.state, state::kStand | state::kYellowCard);
  EXPECT_EQ(player.counters.kick, 4);
  expect_near(player.position, {-3, -37});
}

/// Two full teams; (change_player_type ...) of the left coach.
class Substitution : public ::testing::Test {
 protected:
  Substitution() : world(make_match({})) {
    for (int unum = 1; unum <= 11; ++unum) {
      for (const Side side : {Side::kLeft, Side::kRight}) join(world, side, unum == 1, 18);
    }
  }

  static std::string text_of(const soccer::ServerReply& reply) {
    if (const auto* warning = std::get_if<soccer::WarningReply>(&reply)) return warning->text;
    if (const auto* error = std::get_if<soccer::ErrorReply>(&reply)) return error->text;
    return "ok";
  }
  std::string change(int unum, int type) {
    return text_of(change_type(world, Side::kLeft, unum, type, events));
  }

  void start() {
    kick_off(world, events);
    events.clear();
    world.clock.time = 100;
  }

  World world;
  Events events;
};

TEST_F(Substitution, IsUnlimitedBeforeKickOff) {
  for (int i = 0; i < 6; ++i) EXPECT_EQ(change(2, 3 + i), "ok");
  EXPECT_EQ(world.player(Side::kLeft, 2).type, 8);
  EXPECT_EQ(world.team(Side::kLeft).substitutions, 0);
  EXPECT_EQ(events.size(), 6U);
}

TEST_F(Substitution, AssignsDistinctTypesAtKickOff) {
  change(5, 1);
  change(6, 7);
  kick_off(world, events);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    std::set<int> types;
    for (int unum = 1; unum <= 11; ++unum) types.insert(world.player(side, unum).type);
    EXPECT_EQ(types.size(), 11U);
    EXPECT_EQ(world.player(side, 1).type, 0) << "the goalie comes first";
  }
  EXPECT_EQ(world.player(Side::kLeft, 5).type, 1);
  EXPECT_EQ(world.player(Side::kLeft, 6).type, 7);
  EXPECT_EQ(world.player(Side::kLeft, 2).type, 2);
  EXPECT_EQ(world.player(Side::kRight, 2).type, 1);
}

TEST_F(Substitution, ChecksEveryRuleDuringMatch) {
  start();
  EXPECT_EQ(change(2, 18), "out_of_range_player_type");
  EXPECT_EQ(change(2, -1), "out_of_range_player_type");
  EXPECT_EQ(change(2, 5), "no_left_of_that_type");
  EXPECT_EQ(change(12, 15), "no_such_player");

  Player& player = world.player(Side::kLeft, 2);
  player.stamina.value = 1000;
  player.state |= state::kYellowCard;
  player.cards = 1;
  EXPECT_EQ(change(2, 15), "ok");
  EXPECT_EQ(player.stamina.value, 8000);
  EXPECT_EQ(player.stamina.effort, world.type_of(player).effort_max);
  EXPECT_EQ(player.cards, 0);
  EXPECT_EQ(player.state, state::kStand);
  EXPECT_EQ(change(3, 15), "no_left_of_that_type");
  EXPECT_EQ(change(2, 16), "ok");
  EXPECT_EQ(change(2, 17), "ok");
  EXPECT_EQ(change(4, 14), "no_subs_left");

  world.mode = PlayMode::kPlayOn;
  EXPECT_EQ(change(4, 14), "cannot_sub_while_playon");

  world.mode = PlayMode::kKickInLeft;
  world.clock.time = 8000;
  EXPECT_EQ(change(4, 14), "cannot_sub_while_penalty_shootouts");
}

TEST_F(Substitution, ChangesGoalieOnlyWithoutGoalie) {
  start();
  const auto text = [&](int unum) {
    return text_of(change_goalie(world, Side::kLeft, unum, events));
  };
  EXPECT_EQ(text(4), "goalie_already_exists");
  leave(world, slot_of(Side::kLeft, 1));
  EXPECT_EQ(text(1), "no_such_player");
  EXPECT_EQ(text(4), "ok");
  EXPECT_EQ(world.player(Side::kLeft, 4).state, state::kStand | state::kGoalie);
}

TEST_F(Stamina, RecoversUntilCapacityIsUsedUp) {
  Player& player = stage.add(Side::kLeft, {0, 0});
  player.stamina = {5000, 1.0, 1.0, 70};
  update_stamina(stage.world, player);
  EXPECT_DOUBLE_EQ(player.stamina.value, 5045);
  EXPECT_DOUBLE_EQ(player.stamina.capacity, 25);
  update_stamina(stage.world, player);
  EXPECT_DOUBLE_EQ(player.stamina.value, 5070);
  EXPECT_DOUBLE_EQ(player.stamina.capacity, 0);
  update_stamina(stage.world, player);
  EXPECT_DOUBLE_EQ(player.stamina.value, 5070);
}

TEST_F(Stamina, ExhaustionReducesEffortAndRecovery) {
  Player& player = stage.add(Side::kLeft, {0, 0});
  player.stamina = {2400, 1.0, 1.0, 100000};
  update_stamina(stage.world, player);
  EXPECT_DOUBLE_EQ(player.stamina.recovery, 0.998);
  EXPECT_DOUBLE_EQ(player.stamina.effort, 0.995);
  EXPECT_DOUBLE_EQ(player.stamina.value, 2400 + 45 * 0.998);

  player.stamina.value = 4800;
  update_stamina(stage.world, player);
  EXPECT_DOUBLE_EQ(player.stamina.effort, 1.0);
  EXPECT_DOUBLE_EQ(player.stamina.recovery, 0.998) << "recovery is not restored automatically";
  player.stamina = {0, 0.601, 0.501, 100000};
  update_stamina(stage.world, player);
  EXPECT_DOUBLE_EQ(player.stamina.effort, 0.6);
  EXPECT_DOUBLE_EQ(player.stamina.recovery, 0.5);
}

TEST_F(Stamina, HasNoLimitWithNegativeCapacity) {
  stage = Stage([](auto& server) { server.stamina_capacity = -1.0; });
  Player& player = stage.add(Side::kLeft, {0, 0});
  player.stamina.value = 100;
  stage.step(10);
  EXPECT_GT(player.stamina.value, 300);
  EXPECT_DOUBLE_EQ(player.stamina.capacity, -1.0);
}

TEST(Rules, ErrorNamesInvalidParameter) {
  soccer::ServerParams server;
  server.simulator_step = 0;
  EXPECT_THAT(make_rules(server, {}, 1).error().message, HasSubstr("simulator_step"));
  server = {};
  server.nr_normal_halfs = 2'000'000'000;  // would end before it starts
  EXPECT_EQ(make_rules(server, {}, 1).error().message,
            "server::nr_normal_halfs must be within -1000..1000");
  soccer::PlayerParams player;
  player.player_types = 1000;
  EXPECT_THAT(make_rules({}, player, 1).error().message, HasSubstr("player_types"));
}

TEST(Rules, DrawsTypesFromPlayerSeedOrMatchSeed) {
  soccer::PlayerParams player;
  player.random_seed = 1;
  const auto rules = make_rules({}, player, 99).value();
  EXPECT_NEAR(rules->types[1].player_decay, 0.362655, 1e-6);
  const auto drawn = make_rules({}, {}, 1).value();
  EXPECT_EQ(drawn->player.random_seed, 1);
  EXPECT_EQ(drawn->types[1].player_decay, rules->types[1].player_decay);
}

TEST_F(Trainer, CheckBallReportsPosition) {
  const auto place = [&](Vec2 position) {
    stage.place_ball(position);
    return locate_ball(stage.world);
  };
  EXPECT_EQ(place({0, 0}), soccer::BallPlace::kInField);
  EXPECT_EQ(place({52.58, 0}), soccer::BallPlace::kInField);
  EXPECT_EQ(place({-53.5, 3}), soccer::BallPlace::kGoalLeft);
  EXPECT_EQ(place({53.5, -3}), soccer::BallPlace::kGoalRight);
  EXPECT_EQ(place({53.5, 9}), soccer::BallPlace::kOutOfField);
  EXPECT_EQ(place({0, 34.1}), soccer::BallPlace::kOutOfField);
}

TEST_F(Trainer, MakesNoCallsWithoutReferee) {
  stage = Stage([](auto& server) { server.coach = true; });
  stage.place_ball({52, 0}, {1, 0});
  stage.step(5);
  EXPECT_EQ(stage.world.mode, PlayMode::kPlayOn);
  EXPECT_EQ(stage.world.team(Side::kLeft).score, 0);
  EXPECT_EQ(stage.world.clock.time, 15);
}

}  // namespace
}  // namespace cls::tests
