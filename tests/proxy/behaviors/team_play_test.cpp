// Team play: outlets, marking, support, goalie position.
#include <gtest/gtest.h>

#include <cmath>

#include "base/index.h"
#include "player/behaviors/behaviors.h"
#include "player/movement/home_positions.h"
#include "player/movement/off_ball.h"
#include "player/planner/planner.h"
#include "tests/support/known_pitch.h"

namespace cls::proxy {
namespace {

using protos::PlayerAction;
using protos::PlayerActions;
using soccer::PlayMode;
using soccer::Vec2;
using tests::KnownPitch;

const auto kSetPlay = [](PlayerActions& reply) { reply.add_actions()->mutable_helios_set_play(); };
const auto kGoalie = [](PlayerActions& reply) { reply.add_actions()->mutable_helios_goalie(); };

/// Our goal kick on the left, attackers waiting at the edge of the area.
KnownPitch goal_kick() {
  KnownPitch pitch;
  pitch.set_mode(PlayMode::kGoalKickLeft);
  pitch.place_self({-47.7, -9.3}, 0.0);
  pitch.place_ball({-47.0, -9.16});
  pitch.add_opponent(9, {-34.0, 12.0});
  pitch.add_opponent(10, {-34.0, -12.0});
  pitch.add_opponent(11, {-33.0, 0.0});
  pitch.add_opponent(8, {-22.0, -8.0});
  return pitch;
}

TEST(Outlet, TargetsFreeTeammate) {
  KnownPitch pitch = goal_kick();
  pitch.add_teammate(4, {-38.0, -31.0}, 180.0);
  pitch.add_teammate(6, {-30.0, 0.0}, 180.0);
  const player::PlannerField field(pitch.world);
  const auto outlet = best_outlet(field);
  ASSERT_TRUE(outlet);
  EXPECT_TRUE(outlet->teammate_first);
  EXPECT_LT(distance(outlet->target, {-38.0, -31.0}), 12.0);
}

TEST(Outlet, ClearsFarFromGoalWithoutFreeTeammate) {
  KnownPitch pitch = goal_kick();
  const player::PlannerField field(pitch.world);
  const auto outlet = best_outlet(field);
  ASSERT_TRUE(outlet);
  EXPECT_FALSE(outlet->teammate_first);
  EXPECT_GT(distance(outlet->target, {-52.5, 0.0}), 30.0);
  EXPECT_TRUE(outlet->target.x > -20.0 || std::fabs(outlet->target.y) > 28.0)
      << outlet->target.x << " " << outlet->target.y;
}

TEST(OurGoalKick, IsTakenByFullBackWhileGoalieStays) {
  KnownPitch pitch = goal_kick();
  EXPECT_EQ(set_play_kicker(pitch.world), 2);
  pitch.place_ball({-47.0, 9.16});
  EXPECT_EQ(set_play_kicker(pitch.world), 3);
  KnownPitch goal = goal_kick();
  goal.make_goalie();
  goal.place_self({-50.0, -3.0});
  for (int i = 0; i < 40; ++i) goal.act(kSetPlay);
  EXPECT_LT(goal.world.self.position.x, -48.5);
  EXPECT_LT(std::fabs(goal.world.self.position.y), 7.01);
}

TEST(OurGoalKick, LeavesPenaltyArea) {
  KnownPitch pitch = goal_kick();
  pitch.world.unum = 2;
  pitch.add_teammate(4, {-36.0, -31.0}, 180.0);
  pitch.world.game.last_set_play_start = 100;
  for (int cycle = 1; cycle <= 60; ++cycle) {
    pitch.world.game.set_play_count = cycle;
    pitch.act(kSetPlay);
  }
  const Vec2 ball = pitch.world.ball.position;
  EXPECT_TRUE(ball.x > -36.0 || std::fabs(ball.y) > 20.16) << ball.x << " " << ball.y;
}

TEST(Marking, CoversOpponentAtKickIn) {
  KnownPitch pitch;
  pitch.world.unum = 4;
  pitch.set_mode(PlayMode::kKickInRight);
  pitch.place_ball({-20.0, -34.0});
  pitch.place_self(own_home_position(pitch.world));
  const Vec2 alone{-40.0, -26.0};  // beyond our line: there is no offside at kick-ins
  pitch.add_opponent(10, alone);
  ASSERT_GT(distance(pitch.world.self.position, alone), 8.0);
  for (int i = 0; i < 40; ++i) pitch.act(kSetPlay);
  EXPECT_LT(distance(pitch.world.self.position, alone), 4.0);
  EXPECT_LT(distance(pitch.world.self.position, {-52.5, 0.0}), distance(alone, {-52.5, 0.0}));
}

TEST(Marking, AssignsOnePlayerPerOpponent) {
  KnownPitch pitch;
  pitch.set_mode(PlayMode::kKickInRight);
  pitch.place_ball({-20.0, -34.0});
  const player::TeamPoints homes = home_positions(pitch.world);
  pitch.add_opponent(10, {-40.0, -26.0});
  pitch.add_opponent(11, {-38.0, -10.0});

  for (int unum = 2; unum <= 8; ++unum) {
    if (unum != 7) pitch.add_teammate(unum, homes[base::index(unum - 1)]);
  }

  pitch.place_self(homes[6]);
  int markers = 0;
  for (int unum = 2; unum <= 8; ++unum) {
    KnownPitch other = pitch;
    if (unum != 7) {  // the same pitch from another player's perspective
      other.world.unum = unum;
      other.place_self(homes[base::index(unum - 1)]);
      for (player::PlayerState& teammate : other.world.teammates) {
        if (teammate.unum != unum) continue;
        teammate.unum = 7;
        teammate.position = homes[6];
      }
    }
    if (find_mark(other.world, homes, player::kSetPlayMarking)) ++markers;
  }

  EXPECT_EQ(markers, 2);
}

TEST(Marking, CoversWingerBehindTheDefenseAtKickIn) {
  KnownPitch pitch;
  pitch.world.unum = 5;
  pitch.set_mode(PlayMode::kKickInRight);
  pitch.place_ball({-22.7, 34.0});
  const player::TeamPoints homes = home_positions(pitch.world);

  for (int unum = 2; unum <= 8; ++unum) {
    if (unum != 5) pitch.add_teammate(unum, homes[base::index(unum - 1)]);
  }

  pitch.place_self({-20.0, 22.5});
  pitch.add_opponent(10, {-37.0, 0.0});
  pitch.add_opponent(11, {-39.0, 16.0});
  pitch.add_opponent(9, {-43.0, 30.0});
  const std::optional<player::Mark> mark = find_mark(pitch.world, homes, player::kSetPlayMarking);
  ASSERT_TRUE(mark);
  EXPECT_EQ(mark->opponent->unum, 9);

  player::MarkRules nearer = player::kSetPlayMarking;
  nearer.max_cost_near_goal = 0.0;
  EXPECT_FALSE(find_mark(pitch.world, homes, nearer)) << "too far away";
}

/// Our winger has the ball; the agent is in front of their goal.
KnownPitch attack() {
  KnownPitch pitch;
  pitch.world.unum = 11;
  pitch.place_ball({40.0, 25.0});
  pitch.add_teammate(10, {39.4, 25.0});
  pitch.add_opponent(1, {50.0, 2.0});
  pitch.add_opponent(2, {44.0, 14.0});  // in the direct pass lane
  pitch.add_opponent(3, {46.0, 0.0});
  pitch.add_opponent(5, {48.0, -8.0});
  pitch.place_self(own_home_position(pitch.world));
  return pitch;
}

double lane_clearance(const KnownPitch& pitch, Vec2 point) {
  const soccer::Segment way{pitch.world.ball.position, point};
  double least = 100.0;
  for (const player::PlayerState& opponent : pitch.world.opponents) {
    least = std::min(least, distance(way, opponent.position));
  }
  return least;
}

TEST(Support, OpensPassLane) {
  const KnownPitch pitch = attack();
  const player::TeamPoints homes = home_positions(pitch.world);
  const auto position = support_point(pitch.world, homes);
  ASSERT_TRUE(position);
  EXPECT_GT(lane_clearance(pitch, *position), lane_clearance(pitch, homes[10]));
  EXPECT_GT(lane_clearance(pitch, *position), 2.0);
  EXPECT_LT(position->x, pitch.world.lines.offside);
  EXPECT_LT(distance(*position, homes[10]), 8.0);
}

TEST(Support, IsEmptyWithoutOurAttack) {
  KnownPitch pitch = attack();
  const player::TeamPoints homes = home_positions(pitch.world);
  pitch.set_stamina(3000.0);

  EXPECT_FALSE(support_point(pitch.world, homes)) << "low stamina";
  KnownPitch own_half = attack();
  own_half.place_ball({-20.0, 25.0});

  EXPECT_FALSE(support_point(own_half.world, home_positions(own_half.world)));
  KnownPitch theirs;
  theirs.world.unum = 11;
  theirs.place_ball({40.0, 25.0});
  theirs.add_opponent(4, {40.3, 25.0});
  theirs.place_self(own_home_position(theirs.world));
  EXPECT_FALSE(support_point(theirs.world, home_positions(theirs.world)));
}

TEST(GoaliePosition, CoversBothCornersAgainstWing) {
  int saved = 0;
  for (const double aim : {-6.0, -4.0, -2.0, 0.0, 2.0, 4.0, 6.0}) {
    KnownPitch pitch;
    pitch.make_goalie();
    const Vec2 from{-45.0, -12.0};
    pitch.place_ball(from);
    pitch.add_opponent(11, from + Vec2{0.6, 0.0});
    pitch.place_self(goalie_position(pitch.world, from), 90.0);
    pitch.place_ball(from, soccer::with_length(Vec2{-52.5, aim} - from, 2.6));
    pitch.act_until(20, kGoalie, [&] {
      return pitch.sent<soccer::Catch>() != nullptr || pitch.world.ball.position.x < -52.5;
    });
    if (pitch.sent<soccer::Catch>() != nullptr) ++saved;
  }

  EXPECT_GE(saved, 5);
}

TEST(HeliosGoalieMove, StaysInGoalWhileOpponentHasBallBesideIt) {
  KnownPitch pitch;
  pitch.make_goalie();
  pitch.place_self({-50.5, -6.0}, -90.0);
  pitch.add_opponent(11, {-49.4, -9.4});
  for (int cycle = 0; cycle < 10; ++cycle) {
    pitch.place_ball({-49.9, -9.3});
    pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_helios_goalie_move(); });
  }
  EXPECT_LT(std::fabs(pitch.world.self.position.y), 7.3);
}

TEST(PlannerEvaluation, PrefersEarlierOfEqualStates) {
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.0});
  const player::PlannerField field(pitch.world);
  player::Plan plan;
  player::PlanNode node;
  node.holder = 7;
  node.depth = 2;
  node.ball = {10.0, 0.0};
  node.time = 30;
  plan.nodes.push_back(node);
  const double late = default_value(field, plan, 0);
  plan.nodes[0].time = 12;

  EXPECT_GT(default_value(field, plan, 0), late);
}

}  // namespace
}  // namespace cls::proxy
