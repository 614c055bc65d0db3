// The rules of HFO, one by one.
#include <gtest/gtest.h>

#include "soccer/pitch.h"
#include "tests/training/stage.h"
#include "training/tasks/task_rules.h"

namespace cls::tests {
namespace {

using soccer::Side;
using soccer::Vec2;
using training::Status;

/// A world of 1v2 (goalie and a defender), no player near the ball, which lies in the half.
class HalfField : public testing::Test {
 protected:
  HalfField() {
    const auto setup = setup_of(R"({"task": "HalfFieldOffense", "offense": 1, "defense": 2})");
    world_ = setup->prepared;
    options_ = setup->options;
    world_.player(attacker_).position = {5.0, 0.0};
    world_.player(goalie_).position = {52.5, 0.0};
    world_.player(defender_).position = {45.0, 10.0};
    ball({20.0, 0.0});
    memory_.previous_ball = world_.ball.position;
  }

  void ball(Vec2 position) { world_.ball.position = position; }

  /// Judges one cycle.
  Status next() {
    const Status status = task_.judge(world_, options_, memory_);
    memory_.previous_ball = world_.ball.position;
    return status;
  }

  const training::Task task_ = training::half_field_offense();
  simulator::World world_;
  training::OptionValues options_{};
  training::TaskMemory memory_;
  const int attacker_ = soccer::slot_of(Side::kLeft, 11);
  const int goalie_ = soccer::slot_of(Side::kRight, 1);
  const int defender_ = soccer::slot_of(Side::kRight, 2);
};

TEST_F(HalfField, BallBetweenThePostsIsAGoal) {
  ball({52.0, 3.0});
  EXPECT_EQ(next(), Status::kInGame);
  ball({53.0, 3.0});
  EXPECT_EQ(next(), Status::kGoal);
}

TEST_F(HalfField, BallBesideThePostsIsOutOneCycleLater) {
  ball({52.0, 12.0});
  EXPECT_EQ(next(), Status::kInGame);
  ball({53.0, 12.0});
  EXPECT_EQ(next(), Status::kInGame) << "the position of the cycle before counts";
  EXPECT_EQ(next(), Status::kOutOfBounds);
}

TEST_F(HalfField, BallBehindTheMiddleIsOutOneCycleLater) {
  ball({-0.1, 0.0});
  EXPECT_EQ(next(), Status::kInGame);
  EXPECT_EQ(next(), Status::kOutOfBounds);
}

TEST_F(HalfField, TwoCyclesOfADefenderCapture) {
  ball(world_.player(defender_).position);
  EXPECT_EQ(next(), Status::kInGame);
  EXPECT_EQ(next(), Status::kInGame);
  EXPECT_EQ(next(), Status::kCaptured) << "counted in one cycle, judged in the next";
}

TEST_F(HalfField, CyclesOfPossessionNeedNotBeConsecutive) {
  ball(world_.player(defender_).position);
  EXPECT_EQ(next(), Status::kInGame);
  ball({20.0, 0.0});
  EXPECT_EQ(next(), Status::kInGame);
  ball(world_.player(defender_).position);
  EXPECT_EQ(next(), Status::kInGame);
  EXPECT_EQ(next(), Status::kCaptured);
}

TEST_F(HalfField, OnlyTheAttackersPossessionClearsTheCount) {
  ball(world_.player(defender_).position);
  EXPECT_EQ(next(), Status::kInGame);
  ball(world_.player(attacker_).position);
  EXPECT_EQ(next(), Status::kInGame);
  ball(world_.player(defender_).position);
  EXPECT_EQ(next(), Status::kInGame);
  EXPECT_EQ(next(), Status::kInGame) << "one cycle before and two after the attacker";
  EXPECT_EQ(next(), Status::kCaptured);
}

TEST_F(HalfField, GoalieCapturesAtOnce) {
  ball({51.8, 0.0});
  EXPECT_EQ(next(), Status::kCaptured);
}

TEST_F(HalfField, UntouchedBallRunsOutOfTime) {
  int cycles = 0;
  while (next() == Status::kInGame) ++cycles;
  EXPECT_EQ(cycles, 101);
}

TEST_F(HalfField, TouchResetsTheUntouchedCount) {
  for (int i = 0; i < 90; ++i) ASSERT_EQ(next(), Status::kInGame);
  ball(world_.player(attacker_).position);
  EXPECT_EQ(next(), Status::kInGame);
  EXPECT_EQ(memory_.untouched, 0);
}

TEST(HalfFieldStart, PlacesAreInHfosRanges) {
  const auto setup = setup_of(R"({"task": "HalfFieldOffense", "offense": 4, "defense": 4})");
  training::Episode episode(setup);
  double least_x = 99.0;
  double most_x = -99.0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    episode.reset(seed, setup->options);
    const simulator::World& world = episode.world();
    const Vec2 ball = world.ball.position;
    least_x = std::min(least_x, ball.x);
    most_x = std::max(most_x, ball.x);
    ASSERT_LE(std::abs(ball.y), 0.8 * soccer::kHalfWidth);
    for (const int slot : setup->cast.left) {
      const Vec2 place = world.player(slot).position;
      ASSERT_GE(place.x, -0.1);
      ASSERT_LE(place.x, soccer::kHalfLength);
      ASSERT_LE(std::abs(place.x - ball.x), 21.0);
    }
    EXPECT_EQ(world.player(setup->cast.right[0]).position, (Vec2{soccer::kHalfLength, 0.0}));
    for (std::size_t i = 1; i < setup->cast.right.size(); ++i) {
      ASSERT_GE(world.player(setup->cast.right[i]).position.x, 42.0);
    }
  }
  EXPECT_LT(least_x, 0.1);
  EXPECT_GT(most_x, 10.4);
  EXPECT_LE(most_x, 10.5);
}

TEST(HalfFieldStart, NumbersAreHfos) {
  const auto setup = setup_of(R"({"task": "HalfFieldOffense", "offense": 3, "defense": 3})");
  std::vector<int> left;
  std::vector<int> right;
  for (const int slot : setup->cast.left) left.push_back(soccer::unum_of_slot(slot));
  for (const int slot : setup->cast.right) right.push_back(soccer::unum_of_slot(slot));
  EXPECT_EQ(left, (std::vector<int>{11, 7, 8}));
  EXPECT_EQ(right, (std::vector<int>{1, 2, 3}));
  EXPECT_TRUE(setup->prepared.player(setup->cast.right[0]).goalie);
}

}  // namespace
}  // namespace cls::tests
