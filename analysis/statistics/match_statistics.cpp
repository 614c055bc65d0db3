// The families in the order in which they need each other.
#include "analysis/statistics/match_statistics.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/measures/expected_goals.h"

namespace cls::analysis {
namespace {

std::size_t index(std::int8_t slot) { return static_cast<std::size_t>(slot); }

void add_touches(const Flow& flow, PerPlayer<BallWork>& work) {
  for (const Touch& touch : flow.touches) {
    if (touch.live_phase < 0) continue;
    for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot)
      work[slot].touches += touch.touchers >> slot & 1;
  }
}

void add_passes(const std::vector<Pass>& passes, PerPlayer<BallWork>& work) {
  for (const Pass& pass : passes) {
    BallWork& passer = work[index(pass.passer)];
    ++passer.passes;
    passer.crosses += pass.cross;
    passer.losses +=
        pass.outcome == PassOutcome::kIntercepted || pass.outcome == PassOutcome::kContested;
    if (!pass.completed()) continue;
    ++passer.completed;
    passer.pass_length += pass.length();
    passer.pass_gain += std::max(0.0, pass.gain());
    passer.through_passes += pass.through;
    ++work[index(pass.receiver)].received;
  }
}

void add_carries(const std::vector<Carry>& carries, PerPlayer<BallWork>& work) {
  for (const Carry& carry : carries) {
    work[index(carry.slot)].dribbles += carry.dribble;
    work[index(carry.slot)].take_ons += carry.passed;
  }
}

void add_shots(const MatchStatistics& all, PerPlayer<BallWork>& work) {
  for (std::size_t i = 0; i < all.shots.size(); ++i) {
    const Shot& shot = all.shots[i];
    BallWork& shooter = work[index(shot.slot)];
    ++shooter.shots;
    shooter.on_target += shot.on_target;
    shooter.expected_goals += all.expected[i];
    const Assist assist = assist_of(all.flow, all.passes, shot);
    if (assist.passer != kNobody) ++work[index(assist.passer)].key_passes;
  }
  for (std::size_t i = 0; i < all.goals.size(); ++i) {
    const Goal& goal = all.goals[i];
    if (goal.scorer == kNobody) continue;
    ++(goal.own_goal ? work[index(goal.scorer)].own_goals : work[index(goal.scorer)].goals);
    const Assist& assist = all.assists[i];
    if (assist.passer != kNobody) ++work[index(assist.passer)].assists;
    if (assist.second != kNobody) ++work[index(assist.second)].second_assists;
  }
}

std::vector<Assist> assists_of(const MatchStatistics& all) {
  std::vector<Assist> assists;
  for (const Goal& goal : all.goals) {
    const bool by_shot = goal.shot >= 0;
    assists.push_back(
        by_shot ? assist_of(all.flow, all.passes, all.shots[static_cast<std::size_t>(goal.shot)])
                : Assist{});
  }
  return assists;
}

Rating rating_of(const MatchStatistics& all, std::size_t slot) {
  const BallWork& work = all.ball_work[slot];
  Rating rating;
  rating.attack = 10.0 * work.goals + 5.0 * work.assists + 1.5 * work.on_target;
  rating.passing =
      2.0 * work.key_passes + 0.1 * work.completed + 0.02 * work.pass_gain - 0.7 * work.losses;
  rating.defence = 1.0 * all.pressing.interceptions[slot] + 1.0 * all.tackles[slot].effective -
                   8.0 * work.own_goals;
  rating.discipline = -1.0 * all.stoppages.fouls_by[slot] - 2.0 * all.stoppages.yellow_cards[slot] -
                      6.0 * all.stoppages.red_cards[slot];
  const gamelog::MatchRecord& record = *all.flow.record;
  if (record.frames() > 0 && is_goalie(record, entry_of(record.frames() - 1, slot))) {
    const std::size_t team = team_of(slot);
    const auto conceded = std::count_if(
        all.goals.begin(), all.goals.end(),
        [team](const Goal& goal) { return (goal.side == soccer::Side::kLeft ? 0U : 1U) != team; });
    rating.defence += 3.0 * all.goalkeeping[team].saves - 1.5 * static_cast<double>(conceded);
  }
  return rating;
}

}  // namespace

MatchStatistics statistics_of(const gamelog::MatchRecord& record, const gamelog::RclRecord* text) {
  MatchStatistics all;
  all.flow = flow_of(record);
  const Flow& flow = all.flow;
  all.possession = possession_of(flow);
  all.shots = shots_of(flow);
  all.expected = expected_goals(flow, all.shots);
  all.goals = goals_of(flow, all.shots);
  all.passes = passes_of(flow, all.shots);
  all.assists = assists_of(all);
  all.carries = carries_of(flow);
  all.chains = chains_of(flow, all.passes, all.shots);
  all.one_twos = one_twos(flow, all.passes);
  all.tackles = tackles_of(flow);
  all.territory = territory_of(flow);
  all.stoppages = stoppages_of(flow);
  all.goalkeeping = goalkeeping_of(flow, all.shots);
  all.pressing = pressing_of(flow, all.passes, all.stoppages);
  all.movement = movement_of(flow);
  all.stamina = stamina_of(record);
  all.positions = positions_of(flow);
  all.threat = threat_grid(flow, all.passes, all.carries, all.shots, all.expected);
  for (std::size_t team = 0; team < 2; ++team) {
    all.networks[team] = pass_network(all.passes, all.threat, team);
  }
  all.attention = attention_of(record);
  if (text != nullptr) all.responsiveness = responsiveness_of(flow, *text);
  add_touches(flow, all.ball_work);
  add_passes(all.passes, all.ball_work);
  add_carries(all.carries, all.ball_work);
  add_shots(all, all.ball_work);
  const PerPlayer<double> threat = threat_added(all.threat, all.passes, all.carries);
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    all.ball_work[slot].threat = threat[slot];
    all.ratings[slot] = rating_of(all, slot);
  }
  return all;
}

std::vector<std::string> doubts_about(const MatchSummary& summary,
                                      const MatchStatistics& statistics) {
  constexpr double kSilentInSynchMode = 0.01;
  constexpr double kSilent = 0.02;
  const gamelog::MatchRecord& record = *statistics.flow.record;
  std::vector<std::string> doubts;
  if (record.frames() == 0) return {"no frames"};
  if (!summary.complete) {
    doubts.push_back(summary.end_reason.empty() ? "no time_over"
                                                : "ended as " + summary.end_reason);
  }
  const double limit = record.server.synch_mode ? kSilentInSynchMode : kSilent;
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const int at = static_cast<int>(slot);
    const std::string who =
        fmt::format("{} {}", soccer::letter(soccer::side_of_slot(at)), soccer::unum_of_slot(at));
    const std::uint32_t last = record.players.state[entry_of(record.frames() - 1, slot)];
    if (statistics.attention[slot].frames == 0) {
      doubts.push_back(who + " never connected");
    } else if ((last & (gamelog::kStateEnabled | gamelog::kStateRedCard)) == 0) {
      doubts.push_back(who + " was lost");
    }
    if (!statistics.responsiveness) continue;
    const double silent = (*statistics.responsiveness)[slot].silent_share();
    if (silent > limit) doubts.push_back(fmt::format("{} silent in {:.1f} %", who, 100 * silent));
  }
  return doubts;
}

}  // namespace cls::analysis
