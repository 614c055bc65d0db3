// Derived estimates: kick, catch and tackle probabilities, kickable players, lines, stamina.
#include <gtest/gtest.h>

#include "player/estimates/estimates.h"
#include "player/world/running.h"
#include "tests/player/estimates/known_world.h"

namespace cls::player {
namespace {

using tests::add;
using tests::known_world;

/// Moves the ball, and derives what follows from that.
void place_ball(WorldModel& world, Vec2 position) {
  world.ball.position = position;
  update_derived(world);
}

TEST(ActionProbabilities, KickableMarginGrowsWithAge) {
  // Kickable area of the default type: 0.3 + 0.085 + 0.7 = 1.085.
  WorldModel world = known_world();
  for (const auto& [count, limit] : {std::pair{0, 1.03}, {1, 0.93}, {2, 0.83}, {5, 0.83}}) {
    world.ball.seen_pos_count = count;
    world.ball.position = {limit - 0.001, 0.0};
    update_action_probabilities(world);
    update_derived(world);
    EXPECT_TRUE(world.self.kickable) << count;
    place_ball(world, {limit + 0.001, 0.0});
    if (count > 0) {
      EXPECT_FALSE(world.self.kickable) << count;
    }
  }
}

TEST(ActionProbabilities, AreZeroForGhostBall) {
  WorldModel world = known_world();
  world.ball.position = {0.5, 0.0};
  world.ball.ghost_count = 1;
  update_derived(world);
  EXPECT_FALSE(world.self.kickable);
  EXPECT_EQ(world.self.tackle_probability, 0.0);
  EXPECT_EQ(world.self.catch_probability, 0.0);
}

TEST(ActionProbabilities, KickRateDecreasesWithDistanceAndAngle) {
  WorldModel world = known_world();
  place_ball(world, {0.385, 0.0});
  EXPECT_NEAR(world.self.kick_rate, 0.027, 1e-9);
  world.ball.position = {-0.735, 0.0};  // behind, half of the margin away
  update_derived(world);
  EXPECT_NEAR(world.self.kick_rate, 0.027 * (1.0 - 0.25 - 0.125), 1e-9);
  place_ball(world, {30.0, 0.0});
  EXPECT_DOUBLE_EQ(world.self.kick_rate, 0.0001);
}

TEST(ActionProbabilities, TackleFollowsServerFormula) {
  WorldModel world = known_world();
  place_ball(world, {1.0, 0.5});
  // 1 - (1/2)^6 - (0.5/1.25)^6; the foul exponent is 10 and needs an opponent with the ball.
  EXPECT_NEAR(world.self.tackle_probability, 1.0 - 0.015625 - 0.004096, 1e-9);
  EXPECT_EQ(world.self.foul_probability, 0.0);
  add(world, Side::kRight, 9, {1.2, 0.6});
  update_derived(world);
  EXPECT_NEAR(world.self.foul_probability, 1.0 - 0.0009765625 - 0.0001048576, 1e-9);
  world.self.body = AngleDeg(180.0);  // no backward tackle by default
  update_derived(world);
  EXPECT_EQ(world.self.tackle_probability, 0.0);
}

TEST(ActionProbabilities, CatchIsReliableInsideReach) {
  WorldModel world = known_world();
  // Default type: no stretch, so the reach is the diagonal of 1.2 x 0.5.
  EXPECT_NEAR(catch_reach(world).sure, 1.3, 1e-9);
  EXPECT_NEAR(catch_reach(world).farthest, 1.3, 1e-9);
  place_ball(world, {1.2, 0.0});
  EXPECT_EQ(world.self.catch_probability, 1.0);
  place_ball(world, {1.35, 0.0});
  EXPECT_EQ(world.self.catch_probability, 0.0);
  world.ball.position = {1.0, 0.0};
  world.self.catch_ban = 2;
  update_derived(world);
  EXPECT_EQ(world.self.catch_probability, 0.0);
}

TEST(ActionProbabilities, SafetyDashPowerPreservesRecovery) {
  WorldModel world = known_world();
  update_derived(world);
  EXPECT_EQ(world.self.safety_dash_power, 100.0);
  world.self.stamina = 2440.0;  // threshold 0.3 * 8000 + 1
  update_derived(world);
  EXPECT_NEAR(world.self.safety_dash_power, 39.0, 1e-9);
  world.self.capacity = 0.0;
  world.self.stamina = 10.0;
  update_derived(world);
  EXPECT_NEAR(world.self.safety_dash_power, 60.0, 1e-9);  // extra stamina 50
}

TEST(Stamina, RecoveryIsComputedFromSenseBody) {
  // Dash at full power until exhausted, by the server's rules, and compare with perception's
  // estimate.
  WorldModel world = known_world();
  const soccer::ServerParams server;
  const soccer::PlayerType type;
  Stamina truth{8000.0, 1.0, 1.0, 130600.0};
  soccer::SenseBody sense;
  sense.capacity = truth.capacity;
  sense.stamina = truth.stamina;
  on_sense_body(world, sense);

  double least = 1.0;
  for (int cycle = 1; cycle < 400; ++cycle) {
    truth.step(server, type, std::min(100.0, truth.stamina));
    sense.time = cycle;
    sense.stamina = truth.stamina;
    sense.effort = truth.effort;
    sense.capacity = truth.capacity;
    on_sense_body(world, sense);
    EXPECT_NEAR(world.self.recovery, truth.recovery, 1e-9) << cycle;
    least = std::min(least, truth.recovery);
  }

  EXPECT_NEAR(least, 0.5, 1e-9);

  sense.time = 400;  // new half
  sense.stamina = 8000.0;
  sense.capacity = 130600.0;
  on_sense_body(world, sense);
  EXPECT_EQ(world.self.recovery, 1.0);
}

TEST(KickablePlayers, AreNearestOfEachTeamInReach) {
  WorldModel world = known_world();
  world.self.position = {-20.0, 0.0};
  world.ball.position = {0.0, 0.0};
  add(world, Side::kLeft, 9, {0.9, 0.0});
  add(world, Side::kLeft, 10, {0.0, 0.7});
  add(world, Side::kLeft, 11, {0.0, 0.3}, 4);  // older than the ball observation
  add(world, Side::kRight, 4, {-1.2, 0.0});    // in reach only with the distance tolerance
  update_derived(world);
  EXPECT_EQ(world.kickable_teammate_id, world.teammate(10)->id);
  EXPECT_EQ(world.kickable_opponent_id, world.opponent(4)->id);
  world.ball.pos_count = kBallPositionAgeLimit;
  update_derived(world);
  EXPECT_FALSE(world.kickable_teammate());
  EXPECT_FALSE(world.kickable_opponent());
}

TEST(TeamLines, FollowSecondLastPlayers) {
  WorldModel world = known_world();
  world.self.position = {-10.0, 0.0};
  world.ball.position = {5.0, 0.0};
  add(world, Side::kLeft, 1, {-48.0, 0.0});
  add(world, Side::kLeft, 2, {-25.0, 5.0});
  add(world, Side::kLeft, 3, {-22.0, -5.0});
  add(world, Side::kRight, 1, {49.0, 0.0});
  add(world, Side::kRight, 2, {30.0, 5.0});
  add(world, Side::kRight, 3, {27.0, -5.0}, 2);
  world.their_goalie_unum = world.our_goalie_unum = 1;
  world.lines.our_defense = -25.0;
  world.lines.their_defense = 30.0;

  update_derived(world);
  EXPECT_DOUBLE_EQ(world.lines.our_defense, -25.0);
  EXPECT_DOUBLE_EQ(world.lines.their_defense, 30.0);
  EXPECT_DOUBLE_EQ(world.lines.offside, 30.0);
  EXPECT_EQ(world.lines.offside_count, 0);
  EXPECT_DOUBLE_EQ(world.lines.our_defense_players, -25.0);
  EXPECT_DOUBLE_EQ(world.lines.their_defense_players, 30.0);

  place_ball(world, {40.0, 0.0});
  EXPECT_DOUBLE_EQ(world.lines.their_defense, 40.0);
  EXPECT_DOUBLE_EQ(world.lines.their_defense_players, 30.0);
  EXPECT_DOUBLE_EQ(world.lines.offside, 40.0);

  world.game.mode = PlayMode::kKickInLeft;
  update_derived(world);
  EXPECT_DOUBLE_EQ(world.lines.offside, 52.5);
}

TEST(TeamLines, StayInOwnHalf) {
  WorldModel world = known_world();
  world.self.position = {30.0, 0.0};
  world.ball.position = {45.0, 0.0};
  world.ball.pos_count = 9;
  add(world, Side::kLeft, 2, {20.0, 5.0});
  add(world, Side::kRight, 2, {-30.0, 5.0});
  add(world, Side::kRight, 3, {-20.0, 5.0});
  update_derived(world);
  EXPECT_DOUBLE_EQ(world.lines.our_defense, 0.0);
  EXPECT_DOUBLE_EQ(world.lines.their_defense, 0.0);
}

// New worlds share the defaults, and copies what was announced until then.
TEST(MatchParameters, ChangeInTheirWorldOnly) {
  const auto announce = [](WorldModel& world, double most) {
    soccer::ServerParams params;
    params.max_dash_power = most;
    on_server_param(world, params);
  };
  WorldModel one;
  announce(one, 50.0);
  EXPECT_EQ(WorldModel().server().max_dash_power, 100.0);

  const WorldModel copy = one;
  announce(one, 40.0);
  EXPECT_EQ(one.server().max_dash_power, 40.0);
  EXPECT_EQ(copy.server().max_dash_power, 50.0);

  // Nobody else reads them now: no third copy is made.
  const MatchParameters* place = one.parameters.get();
  announce(one, 30.0);
  EXPECT_EQ(one.parameters.get(), place);
  EXPECT_EQ(one.server().max_dash_power, 30.0);
}

TEST(PlayerTypes, AreKnownForTeammatesAndDefaultForOpponents) {
  WorldModel world = known_world();
  soccer::PlayerType quick;
  quick.id = 3;
  quick.player_speed_max = 1.2;
  on_player_type(world, quick);
  soccer::PlayerTypeChange change;
  change.unum = 9;
  change.type = 3;
  on_change_player_type(world, change);
  change.unum = 5;
  change.type.reset();
  on_change_player_type(world, change);

  add(world, Side::kLeft, 9, {0.0, 0.0});
  add(world, Side::kRight, 9, {0.0, 0.0});
  add(world, Side::kRight, 0, {5.0, 0.0});
  update_derived(world);
  EXPECT_EQ(world.teammates[0].type_id, 3);
  EXPECT_EQ(world.type_of(world.teammates[0]).player_speed_max, 1.2);
  EXPECT_EQ(world.opponents[0].type_id, 0);
  EXPECT_EQ(world.opponents[1].type_id, -1);
  EXPECT_EQ(world.type_of(world.opponents[1]).id, 0);

  change.unum = 7;
  change.type = 3;
  on_change_player_type(world, change);
  EXPECT_EQ(world.self.type_id, 3);
}

}  // namespace
}  // namespace cls::player
