// Statistics of a team beside those of a reference.
#include "review/reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gamelog/rcg/rcg_reader.h"
#include "tests/support/files.h"

namespace cls::review {
namespace {

using soccer::Side;

// Figures of real play, of which tests change single ones.
class ReferenceTeam : public testing::Test {
 protected:
  static constexpr std::size_t kExpectedGoals = 0;
  static constexpr std::size_t kShots = 4;

  ReferenceTeam() {
    auto read = gamelog::read_rcg_file(tests::fixture("gamelog/match-start.rcg.gz").string());
    EXPECT_TRUE(read);
    record_ = *std::move(read);
    statistics_ = analysis::compute_statistics(record_, nullptr);
    summary_ = analysis::summarize(record_, nullptr);
  }

  Figures figures(Side side) const { return figures_of(summary_, statistics_, side); }

  // Matches that differ in nothing but shots.
  std::vector<Figures> with_shots(const std::vector<double>& shots) const {
    std::vector<Figures> matches;
    for (const double count : shots) {
      matches.push_back(figures(Side::kLeft));
      matches.back()[kShots] = count;
    }
    return matches;
  }

  gamelog::MatchRecord record_;
  analysis::MatchStatistics statistics_;
  analysis::MatchSummary summary_;
};

TEST_F(ReferenceTeam, CountsAreThoseOfAWholeMatch) {
  const Figures left = figures(Side::kLeft);
  const Figures right = figures(Side::kRight);

  EXPECT_GT(left[kExpectedGoals], 0.0);
  EXPECT_EQ(left[kExpectedGoals], right[kExpectedGoals + 1]) << "for one, against the other";
  EXPECT_EQ(left[kExpectedGoals + 1], right[kExpectedGoals]);

  const auto shots = std::ranges::count_if(statistics_.shots, [](const analysis::Shot& shot) {
    return soccer::side_of_slot(shot.slot) == Side::kLeft;
  });
  EXPECT_NEAR(left[kShots], static_cast<double>(shots) * 6000.0 / summary_.cycles, 1e-9);
}

// Welch's t and its degrees of freedom by hand, the quantile by integration of the density.
TEST_F(ReferenceTeam, IntervalsAreWelchsForAllStatisticsTogether) {
  const std::vector<Difference> found =
      differences(with_shots({12, 15, 11, 14}), with_shots({20, 22, 19, 25, 21}));
  ASSERT_EQ(found.size(), 1U) << "statistics without variation are left out";

  const Difference& shots = found.front();
  EXPECT_STREQ(shots.statistic, "shots");
  EXPECT_DOUBLE_EQ(shots.team, 13.0);
  EXPECT_DOUBLE_EQ(shots.reference, 21.4);
  EXPECT_NEAR(shots.difference.value, -8.4, 1e-9);
  EXPECT_NEAR(shots.difference.low, -15.0331, 1e-3);
  EXPECT_NEAR(shots.difference.high, -1.7669, 1e-3);
  EXPECT_NEAR(shots.errors, -8.4 / 1.375984, 1e-5);
  EXPECT_TRUE(shots.certain());
}

TEST_F(ReferenceTeam, FarthestComesFirst) {
  std::vector<Figures> team = with_shots({12, 15, 11, 14});
  std::vector<Figures> reference = with_shots({20, 22, 19, 25});
  for (std::size_t i = 0; i < team.size(); ++i) {
    team[i][kExpectedGoals] = 1.0 + 0.1 * static_cast<double>(i);
    reference[i][kExpectedGoals] = 3.0 + 0.1 * static_cast<double>(i);
  }

  const std::vector<Difference> found = differences(team, reference);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_STREQ(found[0].statistic, "expected goals");
  EXPECT_STREQ(found[0].unit, "goals");
  EXPECT_STREQ(found[1].statistic, "shots");
}

TEST_F(ReferenceTeam, NeedsTwoMatchesThatHaveTheFigure) {
  std::vector<Figures> team = with_shots({12, 15, 11, 14});
  EXPECT_TRUE(differences(with_shots({12}), team).empty());

  for (std::size_t i = 1; i < team.size(); ++i) team[i][kShots] = std::nan("");
  EXPECT_TRUE(differences(team, with_shots({1, 2, 3})).empty());
}

}  // namespace
}  // namespace cls::review
