// Computes all statistics in the order of their dependencies.
#include "analysis/statistics/match_statistics.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/measures/expected_goals.h"

namespace cls::analysis {
namespace {

void add_touches(const Flow& flow, PerPlayer<BallActions>& work) {
  for (const Touch& touch : flow.touches) {
    if (touch.live_phase < 0) continue;
    for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
      work[slot].touches += touch.touchers >> slot & 1;
    }
  }
}

void add_passes(const std::vector<Pass>& passes, PerPlayer<BallActions>& work) {
  for (const Pass& pass : passes) {
    BallActions& passer = work[slot_index(pass.passer)];
    ++passer.passes;
    passer.crosses += pass.cross;
    passer.losses +=
        pass.outcome == PassOutcome::kIntercepted || pass.outcome == PassOutcome::kContested;

    if (!pass.completed()) continue;
    ++passer.completed;
    passer.pass_length += pass.length();
    passer.pass_gain += std::max(0.0, pass.gain());
    passer.through_passes += pass.through;
    ++work[slot_index(pass.receiver)].received;
  }
}

void add_carries(const std::vector<Carry>& carries, PerPlayer<BallActions>& work) {
  for (const Carry& carry : carries) {
    work[slot_index(carry.slot)].dribbles += carry.dribble;
    work[slot_index(carry.slot)].take_ons += carry.passed;
  }
}

void add_shots(const MatchStatistics& all, PerPlayer<BallActions>& work) {
  for (std::size_t i = 0; i < all.shots.size(); ++i) {
    const Shot& shot = all.shots[i];
    BallActions& shooter = work[slot_index(shot.slot)];
    ++shooter.shots;
    shooter.on_target += shot.on_target;
    shooter.expected_goals += all.expected[i];

    const Assist assist = find_assist(all.flow, all.passes, shot);
    if (assist.passer != kNoPlayer) ++work[slot_index(assist.passer)].key_passes;
  }

  for (std::size_t i = 0; i < all.goals.size(); ++i) {
    const Goal& goal = all.goals[i];
    if (goal.scorer == kNoPlayer) continue;
    BallActions& scorer = work[slot_index(goal.scorer)];
    ++(goal.own_goal ? scorer.own_goals : scorer.goals);

    const Assist& assist = all.assists[i];
    if (assist.passer != kNoPlayer) ++work[slot_index(assist.passer)].assists;
    if (assist.second != kNoPlayer) ++work[slot_index(assist.second)].second_assists;
  }
}

std::vector<Assist> find_assists(const MatchStatistics& all) {
  std::vector<Assist> assists;
  for (const Goal& goal : all.goals) {
    assists.push_back(goal.shot < 0
                          ? Assist{}
                          : find_assist(all.flow, all.passes, all.shots[base::index(goal.shot)]));
  }
  return assists;
}

Rating rating_of(const MatchStatistics& all, std::size_t slot) {
  const BallActions& work = all.ball_actions[slot];
  Rating rating;
  rating.attack = 10.0 * work.goals + 5.0 * work.assists + 1.5 * work.on_target;
  rating.passing =
      2.0 * work.key_passes + 0.1 * work.completed + 0.02 * work.pass_gain - 0.7 * work.losses;
  rating.defense = 1.0 * all.pressing.interceptions[slot] + 1.0 * all.tackles[slot].effective -
                   8.0 * work.own_goals;
  rating.discipline = -1.0 * all.stoppages.fouls_by[slot] - 2.0 * all.stoppages.yellow_cards[slot] -
                      6.0 * all.stoppages.red_cards[slot];

  if (was_goalie(*all.flow.record, slot)) {
    const std::size_t team = team_of(slot);
    const auto conceded = std::ranges::count_if(
        all.goals, [team](const Goal& goal) { return team_of(goal.side) != team; });
    rating.defense += 3.0 * all.goalkeeping[team].saves - 1.5 * static_cast<double>(conceded);
  }
  return rating;
}

}  // namespace

MatchStatistics compute_statistics(const gamelog::MatchRecord& record,
                                   const gamelog::RclRecord* text) {
  MatchStatistics all;
  all.flow = build_flow(record);
  const Flow& flow = all.flow;

  all.possession = measure_possession(flow);
  all.shots = find_shots(flow);
  all.expected = expected_goals(flow, all.shots);
  all.goals = find_goals(flow, all.shots);
  all.passes = find_passes(flow, all.shots);
  all.assists = find_assists(all);
  all.carries = find_carries(flow);
  all.chains = find_chains(flow, all.passes, all.shots);
  all.one_twos = one_twos(flow, all.passes);

  all.tackles = count_tackles(flow);
  all.territory = measure_territory(flow);
  all.stoppages = count_stoppages(flow);
  all.goalkeeping = measure_goalkeeping(flow, all.shots);
  all.pressing = measure_pressing(flow, all.passes, all.stoppages);
  all.movement = measure_movement(flow);
  all.stamina = measure_stamina(record);
  all.positions = measure_positions(flow);
  all.threat = threat_grid(flow, all.passes, all.carries, all.shots, all.expected);
  for (std::size_t team = 0; team < 2; ++team) {
    all.networks[team] = pass_network(all.passes, all.threat, team);
  }
  all.attention = measure_attention(record);
  if (text != nullptr) all.responsiveness = measure_responsiveness(flow, *text);

  add_touches(flow, all.ball_actions);
  add_passes(all.passes, all.ball_actions);
  add_carries(all.carries, all.ball_actions);
  add_shots(all, all.ball_actions);
  const PerPlayer<double> threat = threat_added(all.threat, all.passes, all.carries);
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    all.ball_actions[slot].threat = threat[slot];
    all.ratings[slot] = rating_of(all, slot);
  }
  return all;
}

std::vector<std::string> exclusion_reasons(const MatchSummary& summary,
                                           const MatchStatistics& statistics) {
  constexpr double kMaxSilentShareInSynchMode = 0.01;
  constexpr double kMaxSilentShare = 0.02;
  const gamelog::MatchRecord& record = *statistics.flow.record;
  if (record.frames() == 0) return {"no frames"};

  std::vector<std::string> reasons;
  if (!summary.complete) {
    reasons.push_back(summary.end_reason.empty() ? "no time_over"
                                                 : "end reason: " + summary.end_reason);
  }

  const double max_silent = record.server.synch_mode ? kMaxSilentShareInSynchMode : kMaxSilentShare;
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const std::string player = fmt::format("{} {}", soccer::letter(side_of(slot)), unum_of(slot));
    const std::uint32_t last = record.players.state[entry_of(record.frames() - 1, slot)];
    if (statistics.attention[slot].frames == 0) {
      reasons.push_back(player + " never connected");
    } else if ((last & (gamelog::kStateEnabled | gamelog::kStateRedCard)) == 0) {
      reasons.push_back(player + " disconnected");
    }

    if (!statistics.responsiveness) continue;
    const double silent = (*statistics.responsiveness)[slot].silent_share();
    if (silent > max_silent) {
      reasons.push_back(fmt::format("{} silent in {:.1f} % of steps", player, 100 * silent));
    }
  }
  return reasons;
}

}  // namespace cls::analysis
