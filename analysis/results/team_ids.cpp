// Names are better than sides, because a team plays on both sides in a tournament.
#include "analysis/results/team_ids.h"

namespace cls::analysis {

std::array<std::string, 2> team_ids(const MatchSummary& summary) {
  const auto& [left, right] = summary.teams;
  if (left.name == right.name || left.name.empty() || right.name.empty()) return {"left", "right"};
  return {left.name, right.name};
}

}  // namespace cls::analysis
