// Self localization on synthetic messages and simulated runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "player/perception/perception.h"
#include "soccer/pitch.h"
#include "soccer/random.h"
#include "tests/player/tracking/synthetic_senses.h"

namespace cls::player {
namespace {

using tests::TrueWorld;

WorldModel model_of(Side side, int unum = 7) {
  WorldModel world;
  on_init(world, {side, unum, PlayMode::kBeforeKickOff},
          side == Side::kLeft ? tests::kLeftTeam : tests::kRightTeam, false);
  return world;
}

/// Error against the true position, rotated by 180 degrees for the right team.
double position_error(const WorldModel& world, const TrueWorld& truth) {
  const Vec2 own = world.our_side == Side::kRight ? -truth.self.position : truth.self.position;
  return soccer::distance(world.self.position, own);
}

double body_error(const WorldModel& world, const TrueWorld& truth) {
  const double turned = world.our_side == Side::kRight ? 180.0 : 0.0;
  return (world.self.body - AngleDeg(truth.self.body + turned)).abs();
}

void sense_and_see(WorldModel& world, const TrueWorld& truth) {
  on_sense_body(world, tests::sense_of(truth));
  on_see(world, tests::see_of(truth));
}

struct SingleSees {
  double position = 0.0;  ///< mean errors
  double body = 0.0;
  double position_surprise = 0.0;  ///< mean of squared error over estimated variance
  int sees = 0;
};

/// Single see messages at random poses without history.
SingleSees single_sees(Side side, soccer::ViewWidth width) {
  soccer::RandomStream random(11, "single looks");
  SingleSees sum;
  for (int i = 0; i < 400; ++i) {
    TrueWorld truth;
    truth.width = width;
    truth.self.position = {random.uniform(-52.0, 52.0), random.uniform(-33.5, 33.5)};
    truth.self.body = random.uniform(-180.0, 180.0);
    const soccer::See see = tests::see_of(truth);
    WorldModel world = model_of(side);
    on_sense_body(world, tests::sense_of(truth));
    on_see(world, see);

    const bool landmarks = std::ranges::count(see.objects, soccer::ObservedKind::kLandmark,
                                              &soccer::Observation::kind) > 0;
    EXPECT_EQ(world.self.pos_count, landmarks ? 0 : kNever);
    if (!landmarks) continue;

    ++sum.sees;
    const double error = position_error(world, truth);
    const double deviation = world.self.position_deviation;
    sum.position += error;
    sum.body += body_error(world, truth);
    sum.position_surprise += error * error / (2.0 * deviation * deviation);
  }

  sum.position /= sum.sees;
  sum.body /= sum.sees;
  sum.position_surprise /= sum.sees;
  return sum;
}

TEST(SelfLocalization, LocalizesFromSingleSee) {
  struct Limits {
    soccer::ViewWidth width;
    double position;
    double body;
  };
  for (const Side side : {Side::kLeft, Side::kRight}) {
    for (const auto& [width, position, body] : {Limits{soccer::ViewWidth::kWide, 0.025, 0.04},
                                                Limits{soccer::ViewWidth::kNormal, 0.04, 0.07},
                                                Limits{soccer::ViewWidth::kNarrow, 0.08, 0.25}}) {
      const SingleSees sees = single_sees(side, width);
      EXPECT_LT(sees.position, position);
      EXPECT_LT(sees.body, body);
      EXPECT_GT(sees.sees, 380);
    }
  }
}

TEST(SelfLocalization, EstimatesItsVariance) {
  for (const soccer::ViewWidth width :
       {soccer::ViewWidth::kNarrow, soccer::ViewWidth::kNormal, soccer::ViewWidth::kWide}) {
    const SingleSees sees = single_sees(Side::kLeft, width);
    EXPECT_GT(sees.position_surprise, 0.7);
    EXPECT_LT(sees.position_surprise, 1.4);
  }
}

/// A player that randomly dashes, turns and turns its neck by the rules of motion with noise.
struct Runner {
  TrueWorld truth;
  soccer::RandomStream random{5, "run"};
  soccer::ServerParams server;
  soccer::PlayerType type;
  soccer::CommandCounts counts;
  bool leg_dashes = false;

  /// Simulates one cycle; returns the commands sent.
  std::vector<soccer::PlayerCommand> step() {
    std::vector<soccer::PlayerCommand> sent;
    tests::TruePlayer& self = truth.self;
    Vec2 acceleration;

    const auto turn_by = [&](double degrees) {
      const double noise = random.uniform(-server.player_rand, server.player_rand);
      self.body = math::normalize_degrees(self.body + degrees * (1.0 + noise));
    };

    const bool leaving = self.position.length() > 30.0;
    if (random.bernoulli(0.2) || leaving) {
      const double wanted =
          leaving ? math::normalize_degrees(soccer::direction_degrees(-self.position) - self.body)
                  : random.uniform(-180.0, 180.0);
      sent.push_back(soccer::Turn{wanted});
      turn_by(wanted / (1.0 + type.inertia_moment * self.velocity.length()));
      ++counts.turn;
    } else if (leg_dashes) {
      const double left = random.uniform(0.0, 100.0);
      const double right = random.uniform(0.0, 100.0);
      sent.push_back(soccer::LegDash{soccer::Dash{left, 0.0}, soccer::Dash{right, 0.0}});
      acceleration = soccer::polar_degrees(0.5 * (left + right) * type.dash_power_rate, self.body);
      turn_by(math::to_degrees((left - right) * type.dash_power_rate / (2.0 * type.player_size)));
      ++counts.dash;
    } else {
      const double power = random.uniform(0.0, 100.0);
      sent.push_back(soccer::Dash{power, 0.0});
      acceleration = soccer::polar_degrees(power * type.dash_power_rate, self.body);
      ++counts.dash;
    }

    const double neck = std::rint(random.uniform(-60.0, 60.0)) - self.neck;
    sent.push_back(soccer::TurnNeck{neck});
    self.neck += neck;
    ++counts.turn_neck;

    self.velocity += acceleration;
    const double speed = self.velocity.length();
    self.velocity += soccer::polar_degrees(random.uniform(0.0, server.player_rand * speed),
                                           random.uniform(-180.0, 180.0));
    self.position += self.velocity;
    self.velocity *= type.player_decay;
    ++truth.time;
    return sent;
  }

  soccer::SenseBody sense() const {
    soccer::SenseBody out = tests::sense_of(truth);
    out.counts = counts;
    return out;
  }

  /// One cycle of the player and its world model, with a see message or without.
  void play(WorldModel& world, bool see) {
    record_sent_commands(world, step());
    on_sense_body(world, sense());
    if (see) on_see(world, tests::see_of(truth));
  }
};

struct RunErrors {
  double position = 0.0;
  double body = 0.0;
  double velocity = 0.0;
};

/// Mean errors over 300 cycles with a see in every other one.
RunErrors errors_in_a_run(Runner& runner) {
  WorldModel world = model_of(Side::kLeft);
  RunErrors errors;
  constexpr int kCycles = 300;
  for (int i = 0; i < kCycles; ++i) {
    runner.play(world, i % 2 == 0);
    EXPECT_NEAR(world.self.neck.degrees(), runner.truth.self.neck, 1e-9);
    errors.position += position_error(world, runner.truth) / kCycles;
    errors.body += body_error(world, runner.truth) / kCycles;
    errors.velocity += soccer::distance(world.self.velocity, runner.truth.self.velocity) / kCycles;
  }
  return errors;
}

TEST(SelfLocalization, TracksRunBetterThanSingleSees) {
  Runner runner;
  const auto [position, body, velocity] = errors_in_a_run(runner);
  EXPECT_LT(position, 0.02);
  EXPECT_LT(body, 0.5);
  EXPECT_LT(velocity, 0.006);
}

TEST(SelfLocalization, TracksTwoLegDashes) {
  Runner runner;
  runner.leg_dashes = true;
  const auto [position, body, velocity] = errors_in_a_run(runner);
  EXPECT_LT(position, 0.02);
  EXPECT_LT(body, 0.6);
  EXPECT_LT(velocity, 0.006);
}

class DeadReckoning : public testing::TestWithParam<bool> {};

TEST_P(DeadReckoning, EstimatesItsVariance) {
  double position = 0.0;
  double surprise = 0.0;
  constexpr int kRuns = 60;
  for (int seed = 0; seed < kRuns; ++seed) {
    Runner runner;
    runner.leg_dashes = GetParam();
    runner.random = soccer::RandomStream(static_cast<std::uint64_t>(seed), "run");
    WorldModel world = model_of(Side::kLeft);
    for (int i = 0; i < 30; ++i) runner.play(world, i < 20);

    EXPECT_EQ(world.self.pos_count, 10);
    const double error = position_error(world, runner.truth);
    const double deviation = world.self.position_deviation;
    position += error / kRuns;
    surprise += error * error / (2.0 * deviation * deviation) / kRuns;
  }

  EXPECT_LT(position, 0.15);
  EXPECT_GT(surprise, 0.5);
  EXPECT_LT(surprise, 2.0);
}

INSTANTIATE_TEST_SUITE_P(, DeadReckoning, testing::Bool(), [](const auto& legs) {
  return legs.param ? "WithTwoLegDashes" : "WithPlainDashes";
});

TEST(SelfLocalization, DetectsMoveByReferee) {
  TrueWorld truth;
  truth.self.position = {10.0, 5.0};
  truth.self.body = 30.0;
  WorldModel world = model_of(Side::kRight);
  for (int i = 0; i < 5; ++i) {
    ++truth.time;
    sense_and_see(world, truth);
  }

  truth.self.position = {-20.0, 12.0};
  ++truth.time;
  sense_and_see(world, truth);
  EXPECT_LT(position_error(world, truth), 0.2);
  EXPECT_LT(body_error(world, truth), 0.3);
}

TEST(SelfLocalization, AppliesOwnMoveCommandWithoutSee) {
  TrueWorld truth;
  truth.self.position = {-3.0, -37.0};
  WorldModel world = model_of(Side::kLeft);
  sense_and_see(world, truth);

  record_sent_commands(world, {soccer::Move{-20.0, 10.0}});
  ++truth.time;
  soccer::SenseBody sense = tests::sense_of(truth);
  sense.counts.move = 1;
  on_sense_body(world, sense);

  EXPECT_LT(soccer::distance(world.self.position, {-20.0, 10.0}), 1e-9);
  EXPECT_EQ(world.self.pos_count, 0);
  EXPECT_EQ(world.self.seen_pos_count, 1);
}

TEST(SelfLocalization, IgnoresCommandNotExecutedByServer) {
  TrueWorld truth;
  WorldModel world = model_of(Side::kLeft);
  sense_and_see(world, truth);
  record_sent_commands(world, {soccer::Turn{90.0}, soccer::TurnNeck{40.0}});
  ++truth.time;
  sense_and_see(world, truth);
  EXPECT_NEAR(world.self.body.degrees(), 0.0, 0.2);
  EXPECT_NEAR(world.self.neck.degrees(), 0.0, 1e-9);
}

TEST(SelfLocalization, ToleratesMovingFocusPoint) {
  Runner runner;
  soccer::RandomStream random(6, "focus");
  WorldModel world = model_of(Side::kLeft);
  double position = 0.0;
  constexpr int kCycles = 300;
  for (int i = 0; i < kCycles; ++i) {
    record_sent_commands(world, runner.step());
    runner.truth.focus_distance = random.uniform(0.0, 40.0);
    runner.truth.focus_direction = random.uniform(-60.0, 60.0);
    on_sense_body(world, runner.sense());
    if (i % 2 == 0) on_see(world, tests::see_of(runner.truth));
    position += position_error(world, runner.truth) / kCycles;
  }
  EXPECT_LT(position, 0.022);
}

TEST(SelfLocalization, ToleratesFocusPointAtFirstSees) {
  TrueWorld truth;
  truth.self.position = {-12.0, 7.0};
  truth.self.body = 15.0;
  truth.focus_distance = 25.0;
  truth.focus_direction = 20.0;
  WorldModel world = model_of(Side::kLeft);
  for (int i = 0; i < 3; ++i) {
    ++truth.time;
    sense_and_see(world, truth);
  }
  EXPECT_LT(position_error(world, truth), 0.06);
  EXPECT_LT(body_error(world, truth), 0.1);
}

TEST(SelfLocalization, ToleratesLostMessages) {
  Runner runner;
  WorldModel world = model_of(Side::kLeft);
  double worst = 0.0;
  double mean = 0.0;

  for (int i = 0; i < 120; ++i) {
    record_sent_commands(world, runner.step());
    if (i % 10 == 5 || i % 10 == 6) continue;  // neither sense_body nor see
    on_sense_body(world, runner.sense());
    if (i % 10 == 7) {
      EXPECT_GT(world.self.position_deviation, 0.5);
    }
    on_see(world, tests::see_of(runner.truth));
    worst = std::max(worst, position_error(world, runner.truth));
    mean += position_error(world, runner.truth) / 96.0;
  }

  EXPECT_LT(mean, 0.03);
  EXPECT_LT(worst, 0.5);  // a single see in the worst direction
}

TEST(SelfLocalization, IsDeterministic) {
  WorldModel first = model_of(Side::kLeft);
  WorldModel second = model_of(Side::kLeft);
  for (WorldModel* world : {&first, &second}) {
    Runner runner;
    for (int i = 0; i < 50; ++i) runner.play(*world, true);
  }
  EXPECT_EQ(first.self.position, second.self.position);
  EXPECT_EQ(first.self.body.degrees(), second.self.body.degrees());
}

}  // namespace
}  // namespace cls::player
