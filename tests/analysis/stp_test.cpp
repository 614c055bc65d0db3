// The trajectory challenge. Numbers for the recorded goal are what its public scripts print.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "analysis/tables/stp_challenge.h"
#include "base/io/byte_sink.h"
#include "base/io/byte_source.h"
#include "tests/support/error_of.h"
#include "tests/support/files.h"

namespace cls::analysis {
namespace {

using base::MemorySource;
using testing::HasSubstr;

std::string recorded() {
  auto source = base::open_source(tests::fixture("stp/match.tracking.csv.gz").string());
  return base::read_all(**source);
}

std::string cut(const std::string& text, StpFile file, int last_cycle) {
  MemorySource source(text);
  base::StringSink sink;
  const std::string error = tests::error_of(cut_stp_file(source, file, last_cycle, sink));
  return error.empty() ? sink.bytes() : "error: " + error;
}

std::string cycle_of(const std::string& table) {
  MemorySource source(table);
  const auto cycle = stp_last_cycle(source);
  if (!cycle) return "error: " + cycle.error().message;
  return *cycle ? std::to_string(**cycle) : "none";
}

// Rows of one mode each: 'p' play_on, 'l' and 'r' goals, 'k' a kick-off; cycles from 100.
std::string match(const std::string& modes) {
  const std::map<char, const char*> names = {
      {'p', "play_on"}, {'l', "goal_l"}, {'r', "goal_r"}, {'k', "kick_off_l"}};
  std::string table = "#,cycle,playmode\n";
  for (std::size_t i = 0; i < modes.size(); ++i) {
    table += fmt::format("{},{},\"{}\"\n", i, 100 + i, names.at(modes[i]));
  }
  return table;
}

StpRow last_row(const std::string& table) {
  MemorySource source(table);
  const auto row = read_last_stp_row(source, StpColumns::kMotion);
  return row ? *row : StpRow{};
}

base::Result<StpPrediction> read_prediction(const std::string& table) {
  MemorySource source(table);
  return read_stp_prediction(source, StpColumns::kAllPlaces);
}

StpScore score_of(StpModel model) {
  const std::string truth = recorded();
  const StpRow last = last_row(cut(truth, StpFile::kTracking, 139));
  const auto prediction = read_prediction(format_stp_prediction(predict_stp(model, last)));
  MemorySource source(truth);
  const auto score = score_stp_prediction(*prediction, source, last.number);
  EXPECT_TRUE(score) << score.error().message;
  return score ? *score : StpScore{};
}

TEST(Stp, TestsEndThirtyCyclesBeforeTheFirstPlayedGoal) {
  const std::string played(50, 'p');
  EXPECT_EQ(cycle_of(match(played + "l")), "120");
  EXPECT_EQ(cycle_of(match(played + "lll" + played + "l")), "120");
  EXPECT_EQ(cycle_of(match("k" + played.substr(1) + "lll" + played + "l")), "173");
  EXPECT_EQ(cycle_of(match(played.substr(1) + "l")), "none") << "49 frames of play";
  EXPECT_EQ(cycle_of(match(played + "r")), "none");
  EXPECT_EQ(cycle_of(match(played + "k" + "l")), "none");
  EXPECT_EQ(cycle_of(match("")), "none");
}

TEST(Stp, RecordedGoalHasTheTestOfTheScript) {
  const std::string table = recorded();
  EXPECT_EQ(cycle_of(table), "139");
  const std::string test = cut(table, StpFile::kTracking, 139);
  EXPECT_EQ(std::ranges::count(test, '\n'), 35);
  EXPECT_EQ(test, table.substr(0, test.size()));
  EXPECT_EQ(last_row(test).number, 139);
}

TEST(Stp, ScoresAreThoseOfTheScript) {
  const StpScore velocity = score_of(StpModel::kVelocity);
  EXPECT_EQ(fmt::format("{:.4f} {:.4f}", velocity.average, velocity.endpoint), "3.9319 7.8042");
  const StpScore goal = score_of(StpModel::kGoal);
  EXPECT_EQ(fmt::format("{:.4f} {:.4f}", goal.average, goal.endpoint), "3.3825 5.2666");
}

TEST(Stp, LogsEndWithTheLastCycle) {
  EXPECT_EQ(cut("ULG6\n(server_param (a 1))\n(show 1 x)\n(playmode 2 b)\n(show 2 x)\n(show 3 y)\n"
                "(show 1 z)\n",
                StpFile::kGameLog, 2),
            "ULG6\n(server_param (a 1))\n(show 1 x)\n(playmode 2 b)\n(show 2 x)\n");
  EXPECT_EQ(cut("0,1\tx\n7,0\ty\n8,0\tz", StpFile::kTextLog, 7), "0,1\tx\n7,0\ty\n");
  EXPECT_EQ(cut("0,1\tx\n7,0\ty", StpFile::kTextLog, 7), "0,1\tx\n7,0\ty");
  EXPECT_EQ(cut("a,b,c,d,e,f,g,h,i,Time2\n1,1,1,1,1,1,1,1,1,5\n1,1,1,1,1,1,1,1,1,6\n",
                StpFile::kEvents, 5),
            "a,b,c,d,e,f,g,h,i,Time2\n1,1,1,1,1,1,1,1,1,5\n");
  EXPECT_EQ(cut("a\n1\n", StpFile::kEvents, 5), "error: line 2: column 10 must be a cycle");
}

TEST(Stp, CompletePredictionsAreValid) {
  const StpRow last = last_row(cut(recorded(), StpFile::kTracking, 139));
  StpPrediction prediction = predict_stp(StpModel::kVelocity, last);
  EXPECT_FALSE(check_stp_prediction(prediction, 139));
  EXPECT_EQ(check_stp_prediction(prediction, 140), "has no row 170; it must have rows 141 to 170");
  prediction.numbers[4] = 0;
  EXPECT_EQ(check_stp_prediction(prediction, 139), "has no row 144; it must have rows 140 to 169");
}

TEST(Stp, GoalModelEndsInTheGoal) {
  StpRow last;
  last.number = 7;
  last.place[kStpBall] = {32.5, 20};
  last.place[0] = {0, 0};
  last.motion[0] = {0.5, 0};
  const StpPrediction prediction = predict_stp(StpModel::kGoal, last);
  ASSERT_EQ(prediction.numbers.size(), 30u);
  EXPECT_EQ(prediction.numbers.front(), 8);
  EXPECT_EQ(prediction.places.back()[kStpBall], (soccer::Vec2{52.5, 0}));
  EXPECT_NEAR(prediction.places.back()[0].x, 5 + 0.3 * 20, 1e-9);
  EXPECT_NEAR(prediction.places.back()[0].y, -0.15 * 20, 1e-9);
  EXPECT_NEAR(predict_stp(StpModel::kVelocity, last).places[1][0].x, 1.0, 1e-9);
}

TEST(Stp, UnknownPlacesHaveNoScore) {
  const std::string truth = recorded();
  const StpRow last = last_row(cut(truth, StpFile::kTracking, 139));
  StpPrediction prediction = predict_stp(StpModel::kVelocity, last);
  prediction.places.back()[3].x = std::nan("");
  const auto again = read_prediction(format_stp_prediction(prediction));
  ASSERT_TRUE(again);
  MemorySource source(truth);
  EXPECT_TRUE(std::isnan(score_stp_prediction(*again, source, 139)->endpoint));
}

std::string score_error(const StpPrediction& prediction, std::int64_t last) {
  const std::string truth = recorded();
  MemorySource source(truth);
  return tests::error_of(score_stp_prediction(prediction, source, last));
}

TEST(Stp, WrongRowsHaveNoScore) {
  const StpRow last = last_row(cut(recorded(), StpFile::kTracking, 139));
  StpPrediction prediction = predict_stp(StpModel::kVelocity, last);
  EXPECT_EQ(score_error(prediction, 138), "must begin with row 139, behind the test");
  prediction.numbers[7] = 140;
  EXPECT_EQ(score_error(prediction, 139), "has row 140 twice");
  prediction.numbers[7] = 9999;
  EXPECT_EQ(score_error(prediction, 139), "the match has no row 9999");
}

TEST(Stp, ErrorsNameLineAndColumn) {
  EXPECT_EQ(cycle_of(""), "error: is empty");
  EXPECT_EQ(cycle_of("#,cycle\n"), "error: line 1: has no column playmode");
  EXPECT_EQ(cycle_of("#,cycle,playmode\n1,2\n"), "error: line 2: has 2 cells, but 3 columns");
  EXPECT_EQ(cycle_of("#,cycle,playmode\n1,x,p\n"), "error: line 2: cycle: 'x' must be a number");
  EXPECT_EQ(cycle_of("#,cycle,playmode\n1.5,1,p\n"), "error: line 2: #: '1.5' must be an integer");
  EXPECT_EQ(cycle_of("#,cycle,playmode\n,1,p\n"), "error: line 2: #: '' must be an integer");
  EXPECT_EQ(tests::error_of(read_prediction("#,l1_x\n1,2\n")), "line 1: has no column l1_y");
  std::string many = "#\n";
  for (int i = 0; i < 10'001; ++i) many += "1\n";
  MemorySource source(many);
  EXPECT_THAT(read_stp_prediction(source, StpColumns::kNumber).error().message,
              HasSubstr("more than 10000 rows"));
}

}  // namespace
}  // namespace cls::analysis
