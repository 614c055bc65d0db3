// Counts the passes, shots and chains of a team.
#include "analysis/statistics/team_totals.h"

#include <algorithm>
#include <map>

namespace cls::analysis {

PassTotals pass_totals(const MatchStatistics& all, std::size_t team) {
  PassTotals totals;
  double length = 0.0;
  for (const Pass& pass : all.passes) {
    if (team_of(pass.passer) != team) continue;
    ++totals.attempted;
    ++totals.outcomes[base::index(pass.outcome)];
    totals.crosses += pass.cross;
    totals.switches += pass.switched;
    totals.clearances += pass.clearance;

    if (!pass.completed()) continue;
    ++totals.completed;
    ++totals.directions[base::index(pass.direction)];
    length += pass.length();
    totals.through += pass.through;
    totals.cutbacks += pass.cutback;
    totals.overtaken += pass.overtaken;
  }

  if (totals.completed > 0) totals.mean_length = length / totals.completed;
  return totals;
}

ShotTotals shot_totals(const MatchStatistics& all, std::size_t team) {
  ShotTotals totals;
  std::map<std::ptrdiff_t, double> misses;  // by chain: probability that none of its shots scores
  for (std::size_t i = 0; i < all.shots.size(); ++i) {
    const Shot& shot = all.shots[i];
    if (team_of(shot.slot) != team) continue;
    ++totals.total;
    totals.on_target += shot.on_target;
    ++totals.outcomes[base::index(shot.outcome)];
    totals.expected += all.expected[i];

    const auto chain = std::ranges::lower_bound(all.chains, shot.touch, {}, &Chain::last_touch);
    const auto [miss, added] = misses.emplace(chain - all.chains.begin(), 1.0);
    miss->second *= 1.0 - all.expected[i];
  }

  for (const auto& [chain, miss] : misses) totals.expected_by_chain += 1.0 - miss;
  return totals;
}

ChainTotals chain_totals(const MatchStatistics& all, std::size_t team) {
  ChainTotals totals;
  for (const Chain& chain : all.chains) {
    if (chain.team != team) continue;
    ++totals.count;
    totals.mean_passes += chain.passes;
    totals.mean_frames += chain.frames;
    totals.from_set_play += chain.from_set_play;
    ++totals.results[base::index(chain.result)];
  }

  if (totals.count > 0) {
    totals.mean_passes /= totals.count;
    totals.mean_frames /= totals.count;
  }
  return totals;
}

}  // namespace cls::analysis
