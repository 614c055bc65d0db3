// Comparisons: their schedule, samples and verdict.
#include "tournament/report/comparison.h"

#include <gtest/gtest.h>

#include "tests/tournament/fake_executor.h"

namespace cls::tournament {
namespace {

using soccer::EndReason;

Comparison comparison_of(int opponents) {
  Comparison comparison;
  comparison.config = config_of(Format::kList, 2 + opponents);
  return comparison;
}

std::vector<ScheduledMatch> play(const Comparison& comparison, const Referee& referee) {
  std::vector<ScheduledMatch> matches;
  for (const Fixture& fixture : next_fixtures(comparison, {})) {
    matches.push_back(planned(fixture));
    matches.back().outcome = referee(fixture);
  }
  return matches;
}

TEST(Comparison, SchedulesPairsOnOneSeedUntilDecided) {
  const Comparison comparison = comparison_of(0);
  const auto fixtures = next_fixtures(comparison, {});
  ASSERT_EQ(fixtures.size(), 100u);
  EXPECT_EQ(fixtures[0].seed, fixtures[1].seed);
  EXPECT_EQ(fixtures[0].left, fixtures[1].right);
  EXPECT_NE(fixtures[1].seed, fixtures[2].seed);

  const auto matches = play(comparison, better_wins);
  const ComparisonVerdict known = verdict(comparison, matches);
  EXPECT_EQ(known.decision, Decision::kH1);
  EXPECT_EQ(total(known.samples), 6) << "samples after the decision do not count";
  EXPECT_EQ(next_fixtures(comparison, matches).front().index, 101);
}

TEST(Comparison, DecisionIsIndependentOfMatchCompletionOrder) {
  const Comparison comparison = comparison_of(0);
  auto matches = play(comparison, better_wins);
  matches[2].outcome.reset();
  EXPECT_EQ(total(verdict(comparison, matches).samples), 1) << "the second pair is not done";
  matches[2].outcome = fault(EndReason::kCrashed);
  const ComparisonVerdict with_invalid = verdict(comparison, matches);
  EXPECT_EQ(with_invalid.left_out, 1);
  EXPECT_EQ(with_invalid.decision, Decision::kH1);
}

TEST(Comparison, BothTeamsMeetOpponentsOnTheSameSeed) {
  Comparison comparison = comparison_of(2);
  comparison.max_samples = 3;
  const auto fixtures = next_fixtures(comparison, {});
  EXPECT_EQ(pairs_of(fixtures),
            (std::vector<std::string>{"A-C", "C-A", "B-C", "C-B", "A-D", "D-A", "B-D", "D-B", "A-C",
                                      "C-A", "B-C", "C-B"}));

  for (int i = 1; i < 4; ++i) EXPECT_EQ(fixtures[0].seed, fixtures[base::index(i)].seed);
  EXPECT_NE(fixtures[0].seed, fixtures[4].seed);

  // NEW wins all, BASE draws all: a gain of half the points.
  const auto matches = play(comparison, [](const Fixture& fixture) {
    if (fixture.left == 0) return score(1, 0);
    if (fixture.right == 0) return score(0, 1);
    return score(0, 0);
  });
  const ComparisonVerdict so_far = verdict(comparison, matches);

  EXPECT_EQ(so_far.samples, (Frequencies{0, 0, 0, 0, 0, 0, 3, 0, 0}));
  EXPECT_EQ(so_far.strength.score, 0.75);
  EXPECT_TRUE(next_fixtures(comparison, matches).empty());
}

TEST(Comparison, IgnoresSamplesAboveTheMaximum) {
  Comparison comparison = comparison_of(0);
  comparison.test.kind = TestKind::kSprt;
  EXPECT_EQ(last_match(comparison), std::nullopt);
  EXPECT_NEAR(expected_samples_left(comparison, verdict(comparison, {})), 247, 25);
  EXPECT_NEAR(max_expected_samples(comparison), 396, 1);

  const auto matches = play(comparison, [](const Fixture&) { return score(0, 0); });
  comparison.max_samples = 3;
  EXPECT_EQ(last_match(comparison), 6);

  const ComparisonVerdict known = verdict(comparison, matches);
  EXPECT_EQ(known.samples, (Frequencies{0, 0, 3, 0, 0}));
  EXPECT_EQ(expected_samples_left(comparison, known), 0);
  EXPECT_EQ(expected_samples_left(comparison, verdict(comparison, {})), 3);
  EXPECT_EQ(max_expected_samples(comparison), 3);
}

TEST(Comparison, KeepsTheSprt) {
  Comparison comparison = comparison_of(0);
  comparison.test.kind = TestKind::kSprt;
  const ComparisonVerdict known = verdict(comparison, play(comparison, better_wins));
  EXPECT_EQ(known.decision, Decision::kH1);
  EXPECT_EQ(total(known.samples), 28) << "its log-likelihood ratio gains 0.11 per pair";
  EXPECT_EQ(walkover_samples(comparison), 28);
}

TEST(Comparison, CountsGoalsUpToTheirLimit) {
  Comparison comparison = comparison_of(0);
  comparison.test.measure = Measure::kGoals;
  comparison.max_samples = 2;
  // 5:0 counts as 3:0; A wins the first pair 5:0, 1:0 and loses the second one 0:1, 0:2.
  const auto matches = play(comparison, [](const Fixture& fixture) {
    if (fixture.round == 2) return fixture.left == 0 ? score(0, 1) : score(2, 0);
    return fixture.left == 0 ? score(5, 0) : score(0, 1);
  });
  const ComparisonVerdict known = verdict(comparison, matches);

  EXPECT_EQ(known.samples, (Frequencies{0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(known.points, (Frequencies{1, 0, 0, 0, 1}));
  EXPECT_NEAR(known.hypotheses.mean0, 0.5, 1e-12);
  EXPECT_NEAR(known.hypotheses.mean1, 0.5 + 0.5 / 6, 1e-12) << "half a goal a match of +-3";
  EXPECT_NEAR(advantage(comparison, mean(known.samples)), 0.25, 1e-12);
  EXPECT_EQ(advantage_text(comparison, mean(known.samples)), "+0.25 goals a match");

  comparison.max_samples.reset();
  EXPECT_EQ(walkover_samples(comparison), 6);
}

TEST(Comparison, CountsValuesOfSituationsUpToTheirLimit) {
  Comparison comparison = comparison_of(0);
  comparison.test.measure = Measure::kValue;
  comparison.test.max_goals = kMaxValue;
  comparison.max_samples = 1;
  // A has +2.5 as the left team, and more than the limit as the right one; the score is nothing.
  const auto matches = play(comparison, [](const Fixture& fixture) {
    Outcome outcome = score(0, 4);
    outcome.value = fixture.left == 0 ? 2.5 : -1e300;
    return outcome;
  });
  const ComparisonVerdict known = verdict(comparison, matches);

  EXPECT_EQ(known.samples.size(), std::size_t{4 * kMaxValue * kValueSteps + 1});
  EXPECT_EQ(total(known.samples), 1);
  EXPECT_NEAR(advantage(comparison, mean(known.samples)), (2.5 + kMaxValue) / 2, 1e-9);
  EXPECT_NEAR(known.hypotheses.mean1, 0.5 + 0.25 / kMaxValue, 1e-12);
  EXPECT_EQ(advantage_text(comparison, 0.5 + 0.25 / kMaxValue), "+0.50 goals a match");

  comparison.max_samples.reset();
  EXPECT_EQ(walkover_samples(comparison), 6);
}

TEST(Comparison, CountsGoalsAgainstOpponents) {
  Comparison comparison = comparison_of(1);
  comparison.test.measure = Measure::kGoals;
  comparison.max_samples = 1;
  // NEW wins both by three goals, BASE loses both by one: four goals a match.
  const auto matches = play(comparison, [](const Fixture& fixture) {
    if (fixture.left == 0) return score(3, 0);
    if (fixture.right == 0) return score(0, 3);
    return fixture.left == 1 ? score(0, 1) : score(1, 0);
  });
  const ComparisonVerdict known = verdict(comparison, matches);

  ASSERT_EQ(known.samples.size(), 25u);
  EXPECT_NEAR(advantage(comparison, mean(known.samples)), 4.0, 1e-12);
  EXPECT_EQ(known.strength.score, 1.0) << "by points";
}

TEST(Comparison, ExpectsFewPairsAfterClearResults) {
  Comparison comparison = comparison_of(0);
  EXPECT_EQ(walkover_samples(comparison), 6);
  EXPECT_NEAR(expected_samples_left(comparison, verdict(comparison, {})), 280, 30);
  EXPECT_NEAR(max_expected_samples(comparison), 525, 50);
  comparison.max_samples = 3;
  const auto won = play(comparison, better_wins);
  comparison.max_samples.reset();
  EXPECT_LT(expected_samples_left(comparison, verdict(comparison, won)), 20);
}

}  // namespace
}  // namespace cls::tournament
