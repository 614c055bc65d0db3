// The shoot-out: timing as observed on rcssserver (docs/spec/simulation-model.md 14.4), and
// decision (docs/spec/simulation-model.md 9.14).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simulator/rules/penalty.h"
#include "tests/simulator/stage.h"

namespace cls::tests {
namespace {

using simulator::Player;
using testing::Contains;
using testing::EndsWith;

soccer::ServerParams shoot_out_params() {
  return noise_free_params([](auto& server) {
    server.nr_normal_halfs = 0;
    server.nr_extra_halfs = 0;
  });
}

/// Two full teams right after the kick-off command of a match with only a shoot-out.
class ShootOut : public ::testing::Test {
 protected:
  ShootOut() : stage(shoot_out_params()) {
    stage.world.clock = {};
    for (int unum = 1; unum <= 11; ++unum) {
      stage.add(Side::kLeft, {-3.0 * unum, -20}, unum == 1);
      stage.add(Side::kRight, {3.0 * unum, 20}, unum == 1);
    }
    stage.set_mode(PlayMode::kBeforeKickOff);
    simulator::kick_off(stage.world, stage.events);
    stage.take_calls();
  }

  Side taker() const { return stage.world.referee.penalty.taker_side; }

  void run_to(PlayMode left_mode) {
    if (taker() == Side::kNeutral) stage.step();
    for (int i = 0; i < 400 && stage.world.mode != for_side(left_mode, taker()); ++i) stage.step();
    ASSERT_EQ(stage.world.mode, for_side(left_mode, taker()));
  }

  Player& taking_player() {
    Player* best = nullptr;
    for (Player& player : stage.world.players) {
      if (player.side != taker() || player.goalie || has_kicked(stage.world, player)) continue;
      if (best == nullptr || distance(player.position, stage.world.ball.position) <
                                 distance(best->position, stage.world.ball.position)) {
        best = &player;
      }
    }
    return *best;
  }

  // The next taker kicks; the ball goes in if its side is the one that `scores`, else out of play.
  void kick(Side scores) {
    run_to(PlayMode::kPenaltyReadyLeft);
    Player& player = taking_player();
    const double end = -sign(stage.world.referee.penalty.goal_side);
    stage.place(player, stage.world.ball.position - Vec2{0.6 * end, 0});
    stage.command(player, "(kick 1 0)");
    ASSERT_EQ(stage.world.mode, for_side(PlayMode::kPenaltyTakenLeft, taker()));

    stage.step();
    if (taker() == scores) {
      stage.world.ball.position = {51.0 * end, 0};
      stage.step();
      stage.world.ball.velocity = {3.0 * end, 0};
    } else {
      stage.world.ball.position = {0, 33.0};
      stage.step();
      stage.world.ball.velocity = {0, 3.0};
    }

    stage.step();
  }

  Stage stage;
};

TEST_F(ShootOut, AdvancesByTimeoutsWithoutKicks) {
  Calls calls;
  for (int i = 0; i < 2100 && stage.world.mode != PlayMode::kTimeOver; ++i) {
    stage.step();
    for (std::string& call : stage.take_calls()) calls.push_back(std::move(call));
  }

  ASSERT_GT(calls.size(), 10U);
  // Sides are random; replace their letters.
  Calls sideless;
  for (const std::string& call : calls) {
    const bool has_side = call.ends_with("_l") || call.ends_with("_r");
    sideless.push_back(has_side ? call.substr(0, call.size() - 2) : call);
  }

  EXPECT_EQ(
      Calls(sideless.begin(), sideless.begin() + 8),
      (Calls{"1 penalty_onfield", "1 penalty_setup", "71 penalty_ready", "82 penalty_miss",
             "93 penalty_setup", "164 penalty_ready", "175 penalty_miss", "186 penalty_setup"}));
  EXPECT_EQ(Calls(sideless.end() - 3, sideless.end()),
            (Calls{"1942 penalty_miss", "1942 penalty_draw", "1943 time_over"}));

  // Sides take turns.
  EXPECT_NE(calls[1].back(), calls[4].back());
  EXPECT_EQ(calls[1].back(), calls[7].back());
}

TEST_F(ShootOut, MovesPlayersToRequiredPositions) {
  run_to(PlayMode::kPenaltyReadyLeft);
  int in_circle = 0;
  for (const Player& player : stage.world.players) {
    if (!player.goalie && player.position.length() <= 9.15) ++in_circle;
  }
  // The taker stands within 2 m of the ball, which is 10 m from the center.
  EXPECT_GE(in_circle, 19);
  EXPECT_LE(distance(taking_player().position, stage.world.ball.position), 2.0 + 1e-9);
  EXPECT_NEAR(std::abs(stage.world.ball.position.x), 10.0, 1e-9);
}

TEST_F(ShootOut, CountsGoalForTaker) {
  run_to(PlayMode::kPenaltyReadyLeft);
  const Side first = taker();
  kick(first);
  EXPECT_EQ(stage.world.mode, for_side(PlayMode::kPenaltyScoreLeft, first));
  EXPECT_EQ(stage.world.team(first).penalty_goals, 1);
  EXPECT_EQ(stage.world.team(first).penalty_kicks, 1);
  EXPECT_EQ(stage.world.team(first).score, 0);
}

TEST_F(ShootOut, CountsBallOverTouchLineAsMiss) {
  run_to(PlayMode::kPenaltyReadyLeft);
  const Side first = taker();
  kick(opponent(first));
  EXPECT_EQ(stage.world.mode, for_side(PlayMode::kPenaltyMissLeft, first));
  EXPECT_EQ(stage.world.team(first).penalty_goals, 0);
}

TEST_F(ShootOut, EndsWhenOneSideCannotCatchUp) {
  run_to(PlayMode::kPenaltyReadyLeft);
  const Side first = taker();
  // 3:0 after six kicks, two left for each.
  for (int i = 0; i < 6; ++i) kick(first);
  stage.step(3);
  EXPECT_EQ(stage.world.mode, PlayMode::kTimeOver);
  EXPECT_EQ(stage.world.team(first).penalty_goals, 3);
  EXPECT_THAT(stage.take_calls(),
              Contains(EndsWith(std::string("penalty_winner_") + letter(first))));
}

TEST_F(ShootOut, CallsFoulForKickDuringSetup) {
  stage.step(2);
  const Side first = taker();
  ASSERT_EQ(stage.world.mode, for_side(PlayMode::kPenaltySetupLeft, first));
  Player& defender = stage.world.player(opponent(first), 5);
  stage.place(defender, stage.world.ball.position + Vec2{0, 0.6});
  stage.command(defender, "(kick 10 0)");
  EXPECT_EQ(stage.world.mode, for_side(PlayMode::kPenaltyScoreLeft, first));
  EXPECT_EQ(stage.world.team(first).penalty_goals, 1);
}

}  // namespace
}  // namespace cls::tests
