// The rules of HFO, one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "soccer/pitch.h"
#include "tests/training/stage.h"
#include "training/tasks/task.h"

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

  /// Judges one cycle with the ball there.
  Status next(Vec2 position) {
    ball(position);
    return next();
  }
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
  EXPECT_EQ(next({52.0, 3.0}), Status::kInGame);
  EXPECT_EQ(next({53.0, 3.0}), Status::kGoal);
}

TEST_F(HalfField, BallBesideThePostsIsOutOneCycleLater) {
  EXPECT_EQ(next({52.0, 12.0}), Status::kInGame);
  EXPECT_EQ(next({53.0, 12.0}), Status::kInGame) << "the position of the cycle before counts";
  EXPECT_EQ(next(), Status::kOutOfBounds);
}

TEST_F(HalfField, BallBehindTheMiddleIsOutOneCycleLater) {
  EXPECT_EQ(next({-0.1, 0.0}), Status::kInGame);
  EXPECT_EQ(next(), Status::kOutOfBounds);
}

TEST_F(HalfField, TwoCyclesOfADefenderCapture) {
  EXPECT_EQ(next(world_.player(defender_).position), Status::kInGame);
  EXPECT_EQ(next(), Status::kInGame);
  EXPECT_EQ(next(), Status::kCaptured) << "counted in one cycle, judged in the next";
}

TEST_F(HalfField, CyclesOfPossessionNeedNotBeConsecutive) {
  EXPECT_EQ(next(world_.player(defender_).position), Status::kInGame);
  EXPECT_EQ(next({20.0, 0.0}), Status::kInGame);
  EXPECT_EQ(next(world_.player(defender_).position), Status::kInGame);
  EXPECT_EQ(next(), Status::kCaptured);
}

TEST_F(HalfField, OnlyTheAttackersPossessionClearsTheCount) {
  EXPECT_EQ(next(world_.player(defender_).position), Status::kInGame);
  EXPECT_EQ(next(world_.player(attacker_).position), Status::kInGame);
  EXPECT_EQ(next(world_.player(defender_).position), Status::kInGame);
  EXPECT_EQ(next(), Status::kInGame) << "one cycle before and two after the attacker";
  EXPECT_EQ(next(), Status::kCaptured);
}

TEST_F(HalfField, GoalieCapturesAtOnce) { EXPECT_EQ(next({51.8, 0.0}), Status::kCaptured); }

TEST_F(HalfField, UntouchedBallRunsOutOfTime) {
  int cycles = 0;
  while (next() == Status::kInGame) ++cycles;
  EXPECT_EQ(cycles, 101);
}

TEST_F(HalfField, TouchResetsTheUntouchedCount) {
  for (int i = 0; i < 90; ++i) ASSERT_EQ(next(), Status::kInGame);
  EXPECT_EQ(next(world_.player(attacker_).position), Status::kInGame);
  EXPECT_EQ(memory_.untouched, 0);
}

using Samples = std::map<std::string, std::vector<double>>;

void add_point(Samples& samples, const std::string& name, Vec2 point) {
  samples[name + " x"].push_back(point.x);
  samples[name + " y"].push_back(point.y);
}

// The formulas of HFO's server, with random numbers of the standard library.
Samples drawn_by_hfo(int draws, int attackers) {
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };

  std::vector<Vec2> squares = {{-1, -1}, {-1, 1},  {1, 1},  {1, -1}, {0, 2},
                               {0, -2},  {-2, -2}, {-2, 2}, {2, 2},  {2, -2}};
  Samples samples;

  for (int i = 0; i < draws; ++i) {
    const Vec2 ball = {uniform(0.0, 0.2) * 52.5, uniform(-0.8, 0.8) * 34.0};
    add_point(samples, "ball", ball);
    std::shuffle(squares.begin(), squares.end(), random);
    for (int k = 0; k < attackers; ++k) {
      const Vec2 square = squares[static_cast<std::size_t>(k)];
      const double x = ball.x + 10.5 * (uniform(0.0, 1.0) + square.x);
      const double y = ball.y + 10.5 * (uniform(0.0, 1.0) + square.y);
      add_point(samples, "attacker", {std::clamp(x, -0.1, 52.5), std::clamp(y, -27.2, 27.2)});
    }
    add_point(samples, "defender", {uniform(42.0, 52.5), uniform(-27.2, 27.2)});
  }

  return samples;
}

Samples drawn_by_task(int draws) {
  const auto setup = setup_of(R"({"task": "HalfFieldOffense", "offense": 3, "defense": 2})");
  training::Episode episode(setup);
  Samples samples;
  for (int seed = 0; seed < draws; ++seed) {
    episode.reset(static_cast<std::uint64_t>(seed), setup->options);
    const simulator::World& world = episode.world();
    add_point(samples, "ball", world.ball.position);
    for (const int slot : setup->cast.left) {
      add_point(samples, "attacker", world.player(slot).position);
    }
    EXPECT_EQ(world.player(setup->cast.right[0]).position, (Vec2{soccer::kHalfLength, 0.0}));
    add_point(samples, "defender", world.player(setup->cast.right[1]).position);
  }

  return samples;
}

// The greatest difference of the two distributions (Kolmogorov and Smirnov). Places at a border,
// where many are equal, count once.
double greatest_difference(std::vector<double> one, std::vector<double> other) {
  std::sort(one.begin(), one.end());
  std::sort(other.begin(), other.end());
  const auto share = [](const std::vector<double>& sorted, double value) {
    const auto up_to = std::upper_bound(sorted.begin(), sorted.end(), value + 1e-9);
    return static_cast<double>(up_to - sorted.begin()) / static_cast<double>(sorted.size());
  };
  double most = 0.0;
  for (const auto* values : {&one, &other}) {
    for (const double value : *values) {
      most = std::max(most, std::abs(share(one, value) - share(other, value)));
    }
  }
  return most;
}

TEST(HalfFieldStart, PlacesAreDistributedAsHfos) {
  constexpr int kDraws = 10000;
  const Samples expected = drawn_by_hfo(kDraws, 3);
  const Samples drawn = drawn_by_task(kDraws);
  ASSERT_EQ(drawn.size(), 6U);
  for (const auto& [name, values] : expected) {
    const auto count = static_cast<double>(values.size());
    // 1.63: exceeded by chance in one of a hundred comparisons.
    EXPECT_LT(greatest_difference(drawn.at(name), values), 1.63 * std::sqrt(2.0 / count)) << name;
  }
}

TEST(HalfFieldStart, AttackersStartInDifferentSquares) {
  const auto setup = setup_of(R"({"task": "HalfFieldOffense", "offense": 10})");
  training::Episode episode(setup);
  episode.reset(3, setup->options);
  std::set<std::pair<int, int>> squares;
  int inside = 0;  // not moved to the border
  for (const int slot : setup->cast.left) {
    const Vec2 place = episode.world().player(slot).position;
    if (place.x <= -0.1 || std::abs(place.y) >= 27.2) continue;
    const Vec2 away = (place - episode.world().ball.position) / 10.5;
    squares.insert({static_cast<int>(std::floor(away.x)), static_cast<int>(std::floor(away.y))});
    ++inside;
  }

  EXPECT_EQ(squares.size(), static_cast<std::size_t>(inside));
  EXPECT_GE(inside, 3);
}

TEST(HalfFieldStart, AttackerAtTheBallIsTheOneAskedFor) {
  const auto at_ball = [](int wanted, std::uint64_t seed) {
    const auto setup = setup_of(R"({"task": "HalfFieldOffense", "offense": 3})");
    training::Episode episode(setup);
    training::OptionValues options = setup->options;
    options[1] = wanted;
    episode.reset(seed, options);
    const Vec2 behind = episode.world().ball.position - Vec2{0.1, 0.0};
    for (const int slot : setup->cast.left) {
      if (distance(episode.world().player(slot).position, behind) < 1e-9) {
        return soccer::unum_of_slot(slot);
      }
    }
    return 0;
  };

  EXPECT_EQ(at_ball(0, 1), 0);
  EXPECT_EQ(at_ball(1, 1), 7) << "by uniform number";
  EXPECT_EQ(at_ball(3, 1), 11);

  std::set<int> chosen;
  for (std::uint64_t seed = 0; seed < 40; ++seed) chosen.insert(at_ball(4, seed));

  EXPECT_EQ(chosen, (std::set<int>{7, 8, 11})) << "a random one where there are fewer";
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
