// Estimates from playouts: halves, intervals, sums.
#include "review/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/confidence.h"

namespace cls::review {
namespace {

PlayedDecision played(Worths recorded, std::vector<std::pair<std::string, Worths>> others) {
  PlayedDecision decision;
  decision.decision.kind = DecisionKind::kDribble;
  decision.recorded = std::move(recorded);
  for (auto& [name, worths] : others) {
    Alternative alternative;
    alternative.group = alternative.text = name;
    decision.alternatives.push_back(alternative);
    decision.worths.push_back(std::move(worths));
  }
  return decision;
}

TEST(MeanDifference, IsByPairs) {
  const Estimate same = mean_difference({1.0, 0.0, 3.0}, {0.5, -0.5, 2.5}, 0, 3);
  EXPECT_DOUBLE_EQ(same.value, 0.5);
  EXPECT_NEAR(same.high - same.low, 0.0, 1e-12);

  // Differences 0 and 2: mean 1, standard error 1.
  const Estimate wide = mean_difference({0.0, 2.0}, {0.0, 0.0}, 0, 2);
  EXPECT_DOUBLE_EQ(wide.value, 1.0);
  EXPECT_DOUBLE_EQ(wide.low, 1.0 - base::kNormal95);
  EXPECT_DOUBLE_EQ(wide.high, 1.0 + base::kNormal95);

  EXPECT_DOUBLE_EQ(mean_difference({9.0, 1.0, 2.0}, {0.0, 0.0, 0.0}, 1, 3).value, 1.5);
}

// "lucky" is best in the half that chooses, and costs in the half that estimates.
TEST(Judge, EstimatesWithOtherPlayoutsThanItChooses) {
  const Verdict verdict = judge(played(
      {0.0, 0.0, 0.0, 0.0}, {{"steady", {0.2, 0.2, 0.2, 0.2}}, {"lucky", {0.9, 0.9, -0.1, -0.3}}}));
  ASSERT_TRUE(verdict.better);
  EXPECT_EQ(verdict.best()->text, "lucky");
  EXPECT_DOUBLE_EQ(verdict.cost.value, -0.2);
}

TEST(Judge, KeepsTheRecordedDecisionIfNoneIsBetter) {
  const Verdict verdict = judge(played({0.5, 0.5, 0.5, 0.5}, {{"hold", {0.4, 0.6, 0.9, 0.9}}}));
  EXPECT_FALSE(verdict.better);
  EXPECT_EQ(verdict.best(), nullptr);
  EXPECT_EQ(verdict.cost.value, 0.0);
}

TEST(Groups, AddCostsAndVariances) {
  std::vector<Verdict> verdicts;
  verdicts.push_back(judge(played({0, 0, 0, 0}, {{"pass", {1, 1, 0.5, 1.5}}})));
  verdicts.push_back(judge(played({0, 0, 0, 0}, {{"pass", {1, 1, 0.0, 1.0}}})));
  verdicts.push_back(judge(played({0, 0, 0, 0}, {{"hold", {1, 1, 2.0, 3.0}}})));
  verdicts.push_back(judge(played({0, 0, 0, 0}, {{"hold", {-1, -1, 2.0, 3.0}}})));

  const std::vector<VerdictGroup> groups = group(verdicts);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].better, "hold");
  EXPECT_EQ(groups[0].decisions, 1U);
  EXPECT_EQ(groups[1].better, "pass");
  EXPECT_EQ(groups[1].recorded, "dribble");
  EXPECT_EQ(groups[1].decisions, 2U);
  EXPECT_DOUBLE_EQ(groups[1].cost.value, 1.5);
  // Each has the standard error 0.5.
  EXPECT_NEAR(groups[1].cost.high - groups[1].cost.value, base::kNormal95 * std::sqrt(0.5), 1e-9);
}

}  // namespace
}  // namespace cls::review
