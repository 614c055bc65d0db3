// What all decisions lost, by kind and situation.
#include "review/losses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/confidence.h"
#include "tests/review/recorded_start.h"

namespace cls::review {
namespace {

using soccer::Side;
using testing::HasSubstr;

using Losses = RecordedStart;

// Between two decisions less than the horizon apart, without a goal, one loss ends where the next
// begins: their sum is what the value of the moment lost.
TEST_F(Losses, EndWhereTheNextDecisionBegins) {
  int joined = 0;
  for (const Side side : soccer::kBothSides) {
    const std::vector<Decision> decisions = find_decisions(statistics_, side);
    const std::vector<Loss> losses = losses_of(statistics_, decisions, side);
    ASSERT_EQ(losses.size(), decisions.size());
    for (std::size_t i = 0; i + 1 < losses.size(); ++i) {
      EXPECT_EQ(losses[i].cycle, decisions[i].cycle);
      const bool goal = std::abs(decisions[i].after) == 1.0;
      if (goal || decisions[i + 1].cycle - decisions[i].cycle > kDecisionHorizon) continue;
      ++joined;
      EXPECT_DOUBLE_EQ(losses[i].goals, decisions[i].before - decisions[i + 1].before);
    }
  }
  EXPECT_GT(joined, 10);
}

TEST_F(Losses, OfTheShotThatScoresAreGains) {
  const std::vector<Decision> decisions = find_decisions(statistics_, Side::kLeft);
  const std::vector<Loss> losses = losses_of(statistics_, decisions, Side::kLeft);
  int shots = 0;
  for (std::size_t i = 0; i < losses.size(); ++i) {
    if (decisions[i].kind != DecisionKind::kShot) continue;
    ++shots;
    EXPECT_DOUBLE_EQ(losses[i].goals, decisions[i].before - 1.0);
    EXPECT_THAT(losses[i].name, HasSubstr("shot in their third"));
  }
  EXPECT_EQ(shots, 1);
}

TEST(LossClasses, AddUpAndNameTheWorst) {
  const std::vector<LossClass> classes =
      classes_of({{{"pass in middle", 10, 0.2}, {"dribble in middle", 20, -0.1}},
                  {{"pass in middle", 30, 0.5}, {"pass in middle", 40, 0.1}}});
  ASSERT_EQ(classes.size(), 2U);
  EXPECT_EQ(classes[0].name, "pass in middle");
  EXPECT_EQ(classes[0].decisions, 3U);
  EXPECT_DOUBLE_EQ(classes[0].goals.value, 0.8);
  EXPECT_NEAR(classes[0].goals.high - 0.8, base::kNormal95 * std::sqrt(0.04 + 0.25 + 0.01), 1e-12);
  EXPECT_EQ(classes[0].worst.match, 1U);
  EXPECT_EQ(classes[0].worst.cycle, 30);

  EXPECT_EQ(classes[1].name, "dribble in middle");
  EXPECT_DOUBLE_EQ(classes[1].goals.value, -0.1);
  EXPECT_EQ(classes[1].worst.cycle, 20);
}

}  // namespace
}  // namespace cls::review
