// Sums the statistics of a team.
#include "analysis/statistics/team_totals.h"

#include <map>

namespace cls::analysis {
namespace {

PassTotals pass_totals(const MatchStatistics& all, std::size_t team) {
  PassTotals totals;
  double length = 0.0;
  for (const Pass& pass : all.passes) {
    if (team_of(slot_index(pass.passer)) != team) continue;
    ++totals.attempted;
    ++totals.outcomes[static_cast<std::size_t>(pass.outcome)];
    totals.crosses += pass.cross;
    totals.switches += pass.switched;
    totals.clearances += pass.clearance;
    if (!pass.completed()) continue;
    ++totals.completed;
    ++totals.directions[static_cast<std::size_t>(pass.direction)];
    length += pass.length();
    totals.through += pass.through;
    totals.cutbacks += pass.cutback;
    totals.overtaken += pass.overtaken;
  }
  if (totals.completed > 0) totals.mean_length = length / totals.completed;
  totals.one_twos = all.one_twos[team];
  return totals;
}

ShotTotals shot_totals(const MatchStatistics& all, std::size_t team) {
  ShotTotals totals;
  std::map<std::size_t, double> misses;  // by chain: probability that none of its shots scores
  for (std::size_t i = 0; i < all.shots.size(); ++i) {
    const Shot& shot = all.shots[i];
    if (team_of(slot_index(shot.slot)) != team) continue;
    ++totals.total;
    totals.on_target += shot.on_target;
    ++totals.outcomes[static_cast<std::size_t>(shot.outcome)];
    totals.expected += all.expected[i];
    std::size_t chain = 0;
    while (chain < all.chains.size() && all.chains[chain].last_touch < shot.touch) ++chain;
    const auto [miss, added] = misses.emplace(chain, 1.0);
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
    ++totals.results[static_cast<std::size_t>(chain.result)];
  }
  if (totals.count > 0) {
    totals.mean_passes /= totals.count;
    totals.mean_frames /= totals.count;
  }
  return totals;
}

void add_player(const MatchStatistics& all, std::size_t slot, TeamTotals& totals) {
  const BallActions& work = all.ball_actions[slot];
  totals.touches += work.touches;
  totals.dribbles += work.dribbles;
  totals.take_ons += work.take_ons;
  totals.goals += work.goals;
  totals.own_goals += work.own_goals;
  totals.threat += work.threat;
  totals.interceptions += all.pressing.interceptions[slot];
  totals.distance += all.movement[slot].distance();
  totals.stamina_used += all.stamina[slot].used;
  totals.exhausted_frames += all.stamina[slot].exhausted_frames;
  const Tackles& tackles = all.tackles[slot];
  totals.tackles.tried += tackles.tried;
  totals.tackles.succeeded += tackles.succeeded;
  totals.tackles.failed += tackles.failed;
  totals.tackles.out_of_reach += tackles.out_of_reach;
  totals.tackles.effective += tackles.effective;
  totals.tackles.as_kick += tackles.as_kick;
  if (!all.responsiveness) return;
  const Responsiveness& answers = (*all.responsiveness)[slot];
  totals.steps += answers.steps;
  totals.silent += answers.silent;
  totals.rejected +=
      answers.rejected_kicks + answers.rejected_tackles + answers.rejected_turn_necks;
}

}  // namespace

TeamTotals sum_team(const MatchStatistics& all, std::size_t team) {
  TeamTotals totals;
  for (const std::size_t slot : kTeamSlots[team]) {
    add_player(all, slot, totals);
  }
  for (const Carry& carry : all.carries) totals.carries += team_of(slot_index(carry.slot)) == team;
  totals.passes = pass_totals(all, team);
  totals.shots = shot_totals(all, team);
  totals.chains = chain_totals(all, team);
  return totals;
}

}  // namespace cls::analysis
