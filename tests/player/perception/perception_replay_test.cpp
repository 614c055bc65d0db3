// Accuracy of the world model on recorded matches, against the ground truth of the game log.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/text/number_text.h"
#include "player/perception/perception_error.h"
#include "player/perception/transcript.h"
#include "tests/support/files.h"
#include "tests/support/rcg_lines.h"

namespace cls::player {
namespace {

using GroundTruths = std::map<std::pair<int, int>, GroundTruth>;

GroundTruth truth_of(const gamelog::Frame& frame) {
  GroundTruth truth;
  truth.ball_position = frame.ball_position;
  truth.ball_velocity = frame.ball_velocity;
  for (std::size_t slot = 0; slot < truth.players.size(); ++slot) {
    const gamelog::PlayerFrame& player = frame.players[slot];
    truth.players[slot] = {(player.state & gamelog::kStateEnabled) != 0, player.position,
                           player.body};
  }
  return truth;
}

/// Frames of a log by time and index among frames of the same time.
GroundTruths read_truth(const std::string& log) {
  GroundTruths steps;
  std::map<int, int> repeated;
  for (const gamelog::Frame& frame : tests::read_frames(log)) {
    steps[{frame.time, repeated[frame.time]++}] = truth_of(frame);
  }
  return steps;
}

PerceptionError measure(const std::string& transcript, const GroundTruths& truth) {
  PerceptionError errors;
  const auto done = replay_transcript(transcript, [&](const WorldModel& world) {
    const auto step = truth.find({world.game.time.cycle, world.game.time.stopped});
    if (step != truth.end()) errors.add(world, step->second);
  });
  EXPECT_TRUE(done.errors.empty()) << done.errors.front().what;
  return errors;
}

std::string text_of(const ErrorSummary& error) {
  return fmt::format("{:.3f} / {:.3f} ({})", error.mean, error.p95, error.n);
}

/// Accuracy of the helios proxy on the same input (README of the data set).
struct HeliosAccuracy {
  const char* transcript;
  int unum;
  ErrorSummary self;
  ErrorSummary body_angle;
  ErrorSummary ball;
  ErrorSummary ball_velocity;
  ErrorSummary teammates;
  ErrorSummary opponents;
};

const std::vector<HeliosAccuracy>& helios_accuracy() {
  static const std::vector<HeliosAccuracy> table = {
      {"player_l1_goalie",
       1,
       {0.020, 0.056, 459},
       {0.40, 0.87, 459},
       {1.384, 3.078, 177},
       {0.115, 0.260, 40},
       {1.794, 7.091, 1592},
       {2.599, 10.981, 1627}},
      {"player_l4",
       4,
       {0.048, 0.113, 459},
       {0.72, 2.70, 459},
       {0.573, 1.537, 192},
       {0.080, 0.173, 148},
       {0.664, 1.591, 1278},
       {1.237, 2.251, 1458}},
      {"player_l7",
       7,
       {0.055, 0.125, 459},
       {0.63, 1.44, 459},
       {0.355, 1.001, 264},
       {0.062, 0.147, 239},
       {0.626, 1.631, 797},
       {0.618, 1.468, 1003}},
      {"player_l10",
       10,
       {0.038, 0.094, 459},
       {0.75, 3.39, 459},
       {0.694, 2.109, 194},
       {0.069, 0.209, 78},
       {1.033, 2.352, 1449},
       {0.770, 1.882, 1606}},
  };
  return table;
}

void expect_at_most(const ErrorSummary& got, const ErrorSummary& limit, double factor,
                    const char* what, int unum) {
  EXPECT_LE(got.mean, limit.mean * factor) << what << " of player " << unum;
  EXPECT_LE(got.p95, limit.p95 * factor) << what << " of player " << unum;
  EXPECT_GE(got.n, limit.n) << what << " of player " << unum;
}

TEST(PerceptionReplay, IsAccurateOnFixtureExcerpt) {
  const GroundTruths truth = read_truth(tests::read_file(tests::fixture("perception/game.rcg.gz")));
  const PerceptionError measured =
      measure(tests::read_file(tests::fixture("perception/player_7.txt.gz")), truth);
  EXPECT_EQ(measured.cycles(), 97);
  EXPECT_LT(measured.self().mean, 0.015);
  EXPECT_LT(measured.self().p95, 0.035);
  EXPECT_LT(measured.body_angle().mean, 0.3);
  EXPECT_LT(measured.ball().mean, 0.12);
  EXPECT_GE(measured.ball().n, 66);
  EXPECT_LT(measured.ball_velocity().mean, 0.07);
  EXPECT_LT(measured.teammates().mean, 0.6);
  EXPECT_LT(measured.opponents().mean, 0.6);
  fmt::print("self {}, body {}, ball {}, ball velocity {}, teammates {}, opponents {}\n",
             text_of(measured.self()), text_of(measured.body_angle()), text_of(measured.ball()),
             text_of(measured.ball_velocity()), text_of(measured.teammates()),
             text_of(measured.opponents()));
}

// A player of cls on the embedded server, with Gaussian see and two-leg dashes. Without the noise
// model of Gaussian see and the turns of the legs the mean errors are 0.17 m (own position), 1.4
// degrees (body), 0.06 m/cycle (velocity of the ball).
TEST(PerceptionReplay, IsAccurateWithGaussianSeeAndTwoLegDashes) {
  const GroundTruths truth =
      read_truth(tests::read_file(tests::fixture("perception/gaussian_game.rcg.gz")));
  const std::string transcript =
      tests::read_file(tests::fixture("perception/gaussian_player_7.txt.gz"));
  EXPECT_NE(transcript.find("(dash (l "), std::string::npos);
  const PerceptionError measured = measure(transcript, truth);
  fmt::print("self {}, body {}, ball {}, ball velocity {}, teammates {}, opponents {}\n",
             text_of(measured.self()), text_of(measured.body_angle()), text_of(measured.ball()),
             text_of(measured.ball_velocity()), text_of(measured.teammates()),
             text_of(measured.opponents()));
  EXPECT_GT(measured.cycles(), 100);
  EXPECT_LT(measured.self().mean, 0.03);
  EXPECT_LT(measured.body_angle().mean, 0.4);
  EXPECT_LT(measured.ball().mean, 0.25);
  EXPECT_LT(measured.ball_velocity().mean, 0.03);
  EXPECT_LT(measured.teammates().mean, 0.8);
  EXPECT_LT(measured.opponents().mean, 0.8);
}

TEST(Transcript, ReportsErrorsWithLineAndContinues) {
  const auto nothing = [](const WorldModel&) {};
  const auto done = replay_transcript(
      "# comment\nS>C 1 (see 0)\nS>C\t0.1\t(see 0 ((b) x 3))\r\n"
      "C>S\t0\t(init Us (version 18))\nS>C\t0\t(init l 7 before_kick_off)\n",
      nothing);
  ASSERT_EQ(done.errors.size(), 2u);
  EXPECT_EQ(done.errors[0].line, 2u);
  EXPECT_EQ(done.errors[0].what, "not a transcript line");
  EXPECT_EQ(done.errors[1].line, 3u);
  EXPECT_EQ(done.world.unum, 7);
}

TEST(Transcript, TakesTeamAndGoalieFromInitRequest) {
  const WorldModel world =
      replay_transcript(
          "C>S\t0\t(init Us (version 18) (goalie))\nS>C\t0\t(init r 1 before_kick_off)\n",
          [](const WorldModel&) {})
          .world;
  EXPECT_EQ(world.our_team_name.view(), "Us");
  EXPECT_TRUE(world.goalie);
  EXPECT_EQ(world.our_side, soccer::Side::kRight);
  EXPECT_EQ(world.unum, 1);
}

TEST(Transcript, TakesNumberFromReconnectRequest) {
  const WorldModel world =
      replay_transcript("C>S\t0\t(reconnect Us 5)\nS>C\t0\t(reconnect r free_kick_l)\n",
                        [](const WorldModel&) {})
          .world;
  EXPECT_EQ(world.our_team_name.view(), "Us");
  EXPECT_EQ(world.our_side, soccer::Side::kRight);
  EXPECT_EQ(world.unum, 5);
}

TEST(PerceptionReplay, IsAtLeastAsAccurateAsHelios) {
  const auto log = tests::data("aligned/game.rcg.gz");
  if (!log) GTEST_SKIP() << "no data: set CLS_DATA";
  const GroundTruths truth = read_truth(tests::read_file(*log));
  fmt::print("mean / 95th percentile (samples)\n");
  for (const HeliosAccuracy& helios : helios_accuracy()) {
    const auto transcript =
        tests::data(std::string("aligned/udp/") + helios.transcript + ".txt.gz");
    ASSERT_TRUE(transcript);
    const PerceptionError measured = measure(tests::read_file(*transcript), truth);
    fmt::print("{:2}: self {}, body {}, ball {}, ball velocity {}, teammates {}, opponents {}\n",
               helios.unum, text_of(measured.self()), text_of(measured.body_angle()),
               text_of(measured.ball()), text_of(measured.ball_velocity()),
               text_of(measured.teammates()), text_of(measured.opponents()));
    EXPECT_NEAR(measured.cycles(), 459,
                1);  // the first or last cycle of play_on is counted differently
    // Factors below 1 require a better accuracy than helios.
    expect_at_most(measured.self(), helios.self, 0.6, "position", helios.unum);
    expect_at_most(measured.body_angle(), helios.body_angle, 0.6, "body angle", helios.unum);
    expect_at_most(measured.ball(), helios.ball, 0.85, "ball", helios.unum);
    expect_at_most(measured.ball_velocity(), helios.ball_velocity, 1.0, "ball velocity",
                   helios.unum);
    expect_at_most(measured.teammates(), helios.teammates, 0.9, "teammates", helios.unum);
    expect_at_most(measured.opponents(), helios.opponents, 0.85, "opponents", helios.unum);
  }
}

}  // namespace
}  // namespace cls::player
