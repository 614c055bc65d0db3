// The verdict on pairs is that of `cls compare`.
#include "playground/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "base/text/json.h"
#include "tests/support/error_of.h"
#include "tournament/report/comparison.h"

namespace cls::playground {
namespace {

using testing::HasSubstr;
using tests::error_of;

base::Json judged(const std::vector<int>& points) {
  const auto verdict = verdict_json(base::Json(points).dump());
  EXPECT_TRUE(verdict) << verdict.error().message;
  return base::Json::parse(*verdict);
}

/// The same pairs as matches of `cls compare NEW BASE`.
tournament::ComparisonVerdict compared(const std::vector<int>& points) {
  tournament::Comparison comparison;
  comparison.config.competition.teams.resize(2);
  std::vector<league::ScheduledMatch> matches;

  for (const league::Fixture& fixture : tournament::next_fixtures(comparison, {})) {
    const std::size_t pair = matches.size() / 2;
    if (pair == points.size()) break;
    const int first = std::min(points[pair], 2);
    const int own = fixture.left == 0 ? first : points[pair] - first;
    const int sign = (fixture.left == 0 ? 1 : -1) * (own - 1);
    league::ScheduledMatch match;
    match.fixture = fixture;
    match.outcome.emplace();
    match.outcome->left_score = sign > 0 ? 1 : 0;
    match.outcome->right_score = sign < 0 ? 1 : 0;
    matches.push_back(match);
  }
  return tournament::verdict(comparison, matches);
}

TEST(PlaygroundVerdict, IsThatOfCompare) {
  const std::vector<std::vector<int>> runs = {
      {}, {4}, {4, 3, 2, 4, 1}, {4, 4, 4, 4, 4, 4, 4, 4, 4}, {0, 1, 0, 0, 2, 0, 0, 0, 0, 1, 0}};
  for (const std::vector<int>& points : runs) {
    const base::Json verdict = judged(points);
    const tournament::ComparisonVerdict expected = compared(points);

    EXPECT_EQ(verdict["decision"], league::name(expected.decision));
    EXPECT_EQ(verdict["pairs"], expected.strength.count);
    EXPECT_EQ(verdict["outcomes"], base::Json(expected.samples));
    EXPECT_EQ(verdict["elo"], expected.strength.elo);
    EXPECT_EQ(verdict["forH1"], expected.betting.for_h1());
    EXPECT_EQ(verdict["forH0"], expected.betting.for_h0());
  }
}

TEST(PlaygroundVerdict, DecidesBothWays) {
  EXPECT_EQ(judged({4, 4, 4, 4, 4, 4, 4, 4})["decision"], "H1");
  EXPECT_EQ(judged({4, 4, 4, 4, 4, 4, 4, 4})["pairs"], 6);
  EXPECT_EQ(judged({0, 0, 0, 0, 0, 0, 0, 0})["decision"], "H0");
  EXPECT_EQ(judged({2, 2})["decision"], "open");
}

TEST(PlaygroundVerdict, NamesTheElementThatIsWrong) {
  EXPECT_THAT(error_of(verdict_json("[4, 5]")), HasSubstr("/1"));
  EXPECT_THAT(error_of(verdict_json("{}")), HasSubstr("must be an array"));
  EXPECT_THAT(error_of(verdict_json("[")), HasSubstr("pairs"));
}

}  // namespace
}  // namespace cls::playground
