// The value of a moment: its figures, both sides, and its fit.
#include "review/state_value.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gamelog/rcg/rcg_reader.h"
#include "review/moment.h"
#include "tests/support/files.h"

namespace cls::review {
namespace {

using soccer::Side;
using soccer::Vec2;

// The left team attacks near the right goal, with two opponents and a teammate ahead of the ball.
StateView attack() {
  StateView view;
  view.ball = {35.0, 4.0};
  view.ball_velocity = {1.35, 0.5};
  view.owner = Side::kLeft;
  view.on_pitch.fill(true);
  view.players.fill({0.0, 0.0});
  view.players[9] = {40.0, -2.0};
  view.players[11] = {51.0, 0.0};
  view.players[12] = {42.0, 3.0};
  return view;
}

StateView mirrored(StateView view) {
  view.ball = -view.ball;
  view.ball_velocity = -view.ball_velocity;
  view.owner = soccer::opponent(view.owner);
  const auto players = view.players;
  for (std::size_t slot = 0; slot < players.size(); ++slot) {
    view.players[(slot + 11) % 22] = -players[slot];
  }
  return view;
}

TEST(StateValue, HasTheFiguresOfTheMoment) {
  const StateFigures figures = figures_of(attack(), Side::kLeft);
  EXPECT_EQ(figures[0], 1.0);
  EXPECT_EQ(figures[1], 1.0);
  EXPECT_DOUBLE_EQ(figures[2], 35.0 / 52.5);
  const double close = 1.0 - soccer::distance(Vec2{35.0, 4.0}, Vec2{52.5, 0.0}) / 40.0;
  EXPECT_DOUBLE_EQ(figures[3], close);
  EXPECT_DOUBLE_EQ(figures[4], close * close);
  EXPECT_DOUBLE_EQ(figures[5], close);
  EXPECT_DOUBLE_EQ(figures[6], 0.5);
  EXPECT_DOUBLE_EQ(figures[7], 2.0 / 11.0);
  EXPECT_DOUBLE_EQ(figures[8], 1.0 / 11.0);

  const StateFigures theirs = figures_of(attack(), Side::kRight);
  EXPECT_EQ(theirs[1], 0.0);
  EXPECT_EQ(theirs[3], 0.0);
  EXPECT_DOUBLE_EQ(theirs[6], -0.5);
}

TEST(StateValue, LeavesOutPlayersWhoAreNotOnThePitch) {
  StateView view = attack();
  view.on_pitch[12] = false;
  EXPECT_DOUBLE_EQ(figures_of(view, Side::kLeft)[7], 1.0 / 11.0);
}

TEST(StateValue, IsTheSameFromBothSides) {
  EXPECT_EQ(figures_of(attack(), Side::kLeft), figures_of(mirrored(attack()), Side::kRight));
  EXPECT_EQ(state_value(attack(), Side::kLeft), -state_value(attack(), Side::kRight));
}

TEST(StateValue, IsHigherWithTheBallNearTheirGoal) {
  StateView far = attack();
  far.ball.x = -20.0;
  StateView lost = attack();
  lost.owner = Side::kRight;
  EXPECT_GT(state_value(attack(), Side::kLeft), 0.02);
  EXPECT_GT(state_value(attack(), Side::kLeft), state_value(far, Side::kLeft));
  EXPECT_GT(state_value(attack(), Side::kLeft), state_value(lost, Side::kLeft));
}

TEST(StateValue, OfAWorldIsThatOfTheFrameItWasMadeFrom) {
  const auto record = gamelog::read_rcg_file(tests::fixture("gamelog/match-start.rcg.gz").string());
  ASSERT_TRUE(record);
  const analysis::Flow flow = analysis::build_flow(*record);
  const auto setup = setup_of(*record, {training::Driver::kPlanner, training::Driver::kPlanner});
  ASSERT_TRUE(setup);

  int moments = 0;
  for (std::size_t frame = 20; frame < record->frames(); frame += 31) {
    if (!has_warm_up(flow, frame)) continue;
    ++moments;
    training::Episode episode(*setup);
    episode.reset_at(1, (*setup)->options, start_at(flow, frame));
    EXPECT_DOUBLE_EQ(state_value(view_of(episode.world()), Side::kLeft),
                     state_value(view_of(flow, frame), Side::kLeft))
        << frame;
  }
  EXPECT_GT(moments, 3);
}

// The first goal of this match falls in its cycle 169.
TEST(StateFitter, CountsGoalsWithinTheHorizon) {
  const auto record = gamelog::read_rcg_file(tests::fixture("gamelog/match-start.rcg.gz").string());
  ASSERT_TRUE(record);
  const analysis::Flow flow = analysis::build_flow(*record);
  StateFitter fitter;
  fitter.add(flow);
  std::size_t live = 0;
  std::size_t before_the_goal = 0;
  for (std::size_t frame = 0; frame < record->frames(); frame += 10) {
    if (!flow.is_live(frame)) continue;
    live += 2;
    const int time = record->time[frame];
    if (time < 169 && time + kValueHorizon >= 169) ++before_the_goal;
  }
  EXPECT_EQ(fitter.rows(), live);
  EXPECT_EQ(fitter.goals(), before_the_goal);

  // The mean of the fitted chances is the share of goals, but for the pull towards 0.
  const StateFigures weights = fitter.fit();
  EXPECT_LT(weights[0], 0.0);
  EXPECT_NE(weights, state_weights());
}

TEST(StateFitter, CalibratesByEqualBinsOfRisingChance) {
  const auto record = gamelog::read_rcg_file(tests::fixture("gamelog/match-start.rcg.gz").string());
  ASSERT_TRUE(record);
  StateFitter fitter;
  EXPECT_TRUE(fitter.calibration(3).empty());
  fitter.add(analysis::build_flow(*record));
  const std::vector<CalibrationBin> bins = fitter.calibration(4);
  ASSERT_EQ(bins.size(), 4U);
  for (std::size_t i = 1; i < bins.size(); ++i) {
    EXPECT_GE(bins[i].chance, bins[i - 1].chance);
    EXPECT_NEAR(static_cast<double>(bins[i].moments), static_cast<double>(bins[0].moments), 1.0);
  }
}

}  // namespace
}  // namespace cls::review
