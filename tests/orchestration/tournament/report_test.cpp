// Reports of made-up tournaments in every format.
#include <gtest/gtest.h>

#include "orchestration/tournament/report/report_model.h"
#include "orchestration/tournament/schedule/schedule.h"
#include "tests/orchestration/tournament/fake_executor.h"

namespace cls::orchestration::tournament {
namespace {

using match::EndReason;

Outcome shoot_out(int goals, int left, int right) {
  Outcome outcome = score(goals, goals);
  outcome.left_penalties = left;
  outcome.right_penalties = right;
  return outcome;
}

Outcome forfeit_by_left() {
  Outcome outcome = fault(EndReason::kCrashed);
  outcome.forfeit = true;
  outcome.right_score = 3;
  return outcome;
}

ScheduledMatch with(Outcome outcome) {
  ScheduledMatch match = planned({});
  match.outcome = std::move(outcome);
  return match;
}

TEST(Report, CountsForfeitsAndInvalidMatchesAsPartOfThoseDone) {
  std::vector<ScheduledMatch> matches = {with(score(1, 0)), planned({})};
  EXPECT_EQ(counts_text(count(matches)), "1 of 2 matches done");
  matches.push_back(with(fault(EndReason::kCrashed)));
  EXPECT_EQ(counts_text(count(matches)), "2 of 3 matches done, of these 1 INVALID");
  matches.push_back(with(forfeit_by_left()));
  EXPECT_EQ(counts_text(count(matches)), "3 of 4 matches done, of these 1 forfeited, 1 INVALID");
}

TEST(Report, ShowsShootOutsAndForfeitsInScores) {
  EXPECT_EQ(score_text(with(score(2, 1))), "2:1");
  EXPECT_EQ(score_text(with(shoot_out(2, 4, 3))), "2:2 (4:3 pen)");
  EXPECT_EQ(score_text(with(forfeit_by_left())), "0:3 (forfeit)");
  EXPECT_EQ(score_text(with(fault(EndReason::kStalled))), "stalled");
  EXPECT_EQ(score_text(planned({})), "-");
}

}  // namespace
}  // namespace cls::orchestration::tournament
