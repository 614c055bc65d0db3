// What follows from fixtures and outcomes alone.
#include "orchestration/tournament/schedule/fixture.h"

#include <utility>

namespace cls::orchestration::tournament {

ScheduledMatch planned(Fixture fixture) {
  ScheduledMatch match;
  match.fixture = std::move(fixture);
  return match;
}

int winner_sign(const Outcome& outcome) {
  const auto total = [](int score, const std::optional<int>& penalties) {
    return std::pair(score, penalties.value_or(0));
  };
  const auto left = total(outcome.left_score, outcome.left_penalties);
  const auto right = total(outcome.right_score, outcome.right_penalties);
  return left == right ? 0 : left > right ? 1 : -1;
}

}  // namespace cls::orchestration::tournament
