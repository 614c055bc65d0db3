// Repeats the schedule round by round from the recorded outcomes.
#include "league/schedule/schedule_check.h"

#include <fmt/format.h>

#include <vector>

#include "league/schedule/schedule.h"

namespace cls::league {

using base::Error;
using base::Result;

Result<void> check_teams(const Competition& competition, const Fixture& fixture) {
  const int teams = competition.team_count();
  for (const int team : {fixture.left, fixture.right}) {
    if (team >= 0 && team < teams) continue;
    return Error{fmt::format("match {}: there is no team {}: the plan has {} teams, from 0",
                             fixture.index, team, teams)};
  }
  if (fixture.left != fixture.right) return {};
  return Error{fmt::format("match {}: team {} meets itself", fixture.index, fixture.left)};
}

Result<void> check_rows(const Competition& competition, std::span<const ScheduledMatch> matches) {
  int expected = 1;
  for (const ScheduledMatch& match : matches) {
    const int index = match.fixture.index;
    if (index != expected) {
      return Error{index > expected ? fmt::format("match {} is missing", expected)
                                    : fmt::format("match number {} is out of place", index)};
    }
    TRY(check_teams(competition, match.fixture));
    ++expected;
  }
  return {};
}

std::optional<Contradiction> find_contradiction(const Competition& competition,
                                                std::span<const ScheduledMatch> matches) {
  std::size_t known = 0;
  while (true) {
    const int first = static_cast<int>(known) + 1;
    const std::vector<Fixture> next = next_fixtures(competition, matches.first(known));

    for (std::size_t i = 0; i < next.size(); ++i) {
      const std::size_t at = known + i;
      // A round is scheduled as a whole, or not yet.
      if (at == matches.size()) {
        if (i == 0) return {};
        return Contradiction{first, fmt::format("match {} is missing", at + 1)};
      }
      Fixture expected = next[i];
      if (matches[at].replay_seed) expected.seed = *matches[at].replay_seed;
      if (matches[at].fixture == expected) continue;
      return Contradiction{first,
                           fmt::format("match {} is not the one that the plan schedules", at + 1)};
    }

    known += next.size();
    if (!next.empty()) continue;
    if (known == matches.size()) return {};
    return Contradiction{first, fmt::format("match {} is not scheduled by the plan", first)};
  }
}

Result<void> check_schedule(const Competition& competition,
                            std::span<const ScheduledMatch> matches) {
  if (const auto found = find_contradiction(competition, matches)) return Error{found->problem};
  return {};
}

}  // namespace cls::league
