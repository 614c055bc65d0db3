// The one list of statistics of teams and players. JSON, CSV, text and pages refer to its rows; a
// path that no row has does not compile.
#pragma once

#include <cstddef>
#include <string_view>

#include "analysis/statistics/fields.h"

namespace cls::analysis {

/// One team of a match.
struct TeamView {
  const MatchSummary& summary;
  const MatchStatistics& all;
  const TeamTotals& totals;
  std::size_t team = 0;

  double part(const PerTeam<int>& frames) const {
    return team == 0 ? left_share(frames) : 1.0 - left_share(frames);
  }
  int passes(PassOutcome outcome) const {
    return totals.passes.outcomes[static_cast<std::size_t>(outcome)];
  }
  int shots(ShotOutcome outcome) const {
    return totals.shots.outcomes[static_cast<std::size_t>(outcome)];
  }
  const Pressing& pressing() const { return all.pressing.teams[team]; }
  const TeamTerritory& territory() const { return all.territory.teams[team]; }
  const TeamStoppages& stoppages() const { return all.stoppages.teams[team]; }
  const Goalkeeping& goalie() const { return all.goalkeeping[team]; }
  const TeamShape& shape() const { return all.positions.teams[team]; }
  const PassNetwork& network() const { return all.networks[team]; }
};

/// One player of a match.
struct PlayerView {
  const MatchStatistics& all;
  std::size_t slot = 0;

  const BallActions& ball() const { return all.ball_actions[slot]; }
  const Tackles& tackles() const { return all.tackles[slot]; }
  const Movement& movement() const { return all.movement[slot]; }
  const Stamina& stamina() const { return all.stamina[slot]; }
  const Positions& position() const { return all.positions.players[slot]; }
  const PassNode& node() const { return all.networks[team_of(slot)].nodes[slot % kTeamSize]; }
  const Attention& attention() const { return all.attention[slot]; }
  double attentive(int frames) const { return share(frames, attention().frames); }
  const Rating& rating() const { return all.ratings[slot]; }
};

/// A statistic: its path in the JSON object, and its value. A row whose value is discarded has
/// none in this match.
template <class View>
struct Field {
  std::string_view path;
  Json (*value)(const View&);
};

// Values of several parts.
Json discarded();
Json chain_results_json(const ChainTotals& totals);
Json edges_json(const PassNetwork& network);
Json targets_json(const Attention& attention);
Json counters_json(const gamelog::Counters& counters);
Json is_goalie_json(const PlayerView& player);
Json type_json(const PlayerView& player);
Json responsiveness_json(const PlayerView& player);
template <typename Values>
Json shares_json(const Values& values) {
  int sum = 0;
  for (const int value : values) sum += value;
  Json list = Json::array();
  for (const int value : values) list.push_back(share(value, sum));
  return list;
}

namespace field_rows {

using T = const TeamView&;
using P = const PlayerView&;

inline constexpr Field<TeamView> kTeamFields[] = {
    {"/name", [](T t) -> Json { return t.summary.teams[t.team].name; }},
    {"/score", [](T t) -> Json { return t.summary.teams[t.team].score; }},
    {"/possession/last_touch", [](T t) -> Json { return t.part(t.all.possession.last_touch); }},
    {"/possession/next_kicker", [](T t) -> Json { return t.part(t.all.possession.next_kicker); }},
    {"/possession/at_feet", [](T t) -> Json { return t.part(t.all.possession.at_feet); }},
    {"/possession/fastest", [](T t) -> Json { return t.part(t.all.possession.fastest); }},
    {"/possession/all_play", [](T t) -> Json { return t.part(t.all.possession.all_play); }},
    {"/possession/last_touch_frames",
     [](T t) -> Json { return t.all.possession.last_touch[t.team]; }},
    {"/possession/at_feet_frames", [](T t) -> Json { return t.all.possession.at_feet[t.team]; }},
    {"/touches", [](T t) -> Json { return t.totals.touches; }},
    {"/passes/attempted", [](T t) -> Json { return t.totals.passes.attempted; }},
    {"/passes/completed", [](T t) -> Json { return t.totals.passes.completed; }},
    {"/passes/completion",
     [](T t) -> Json { return share(t.totals.passes.completed, t.totals.passes.attempted); }},
    {"/passes/mean_length", [](T t) -> Json { return t.totals.passes.mean_length; }},
    {"/passes/forward", [](T t) -> Json { return t.totals.passes.directions[0]; }},
    {"/passes/left", [](T t) -> Json { return t.totals.passes.directions[1]; }},
    {"/passes/right", [](T t) -> Json { return t.totals.passes.directions[2]; }},
    {"/passes/back", [](T t) -> Json { return t.totals.passes.directions[3]; }},
    {"/passes/intercepted", [](T t) -> Json { return t.passes(PassOutcome::kIntercepted); }},
    {"/passes/contested", [](T t) -> Json { return t.passes(PassOutcome::kContested); }},
    {"/passes/out", [](T t) -> Json { return t.passes(PassOutcome::kOut); }},
    {"/passes/offside", [](T t) -> Json { return t.passes(PassOutcome::kOffside); }},
    {"/passes/stopped", [](T t) -> Json { return t.passes(PassOutcome::kStopped); }},
    {"/passes/through", [](T t) -> Json { return t.totals.passes.through; }},
    {"/passes/crosses", [](T t) -> Json { return t.totals.passes.crosses; }},
    {"/passes/switches", [](T t) -> Json { return t.totals.passes.switches; }},
    {"/passes/cutbacks", [](T t) -> Json { return t.totals.passes.cutbacks; }},
    {"/passes/clearances", [](T t) -> Json { return t.totals.passes.clearances; }},
    {"/passes/one_twos", [](T t) -> Json { return t.totals.passes.one_twos; }},
    {"/passes/overtaken", [](T t) -> Json { return t.totals.passes.overtaken; }},
    {"/chains/count", [](T t) -> Json { return t.totals.chains.count; }},
    {"/chains/mean_passes", [](T t) -> Json { return t.totals.chains.mean_passes; }},
    {"/chains/mean_frames", [](T t) -> Json { return t.totals.chains.mean_frames; }},
    {"/chains/from_set_play", [](T t) -> Json { return t.totals.chains.from_set_play; }},
    {"/chains/results", [](T t) -> Json { return chain_results_json(t.totals.chains); }},
    {"/carries", [](T t) -> Json { return t.totals.carries; }},
    {"/dribbles", [](T t) -> Json { return t.totals.dribbles; }},
    {"/take_ons", [](T t) -> Json { return t.totals.take_ons; }},
    {"/shots/total", [](T t) -> Json { return t.totals.shots.total; }},
    {"/shots/on_target", [](T t) -> Json { return t.totals.shots.on_target; }},
    {"/shots/goal", [](T t) -> Json { return t.shots(ShotOutcome::kGoal); }},
    {"/shots/saved", [](T t) -> Json { return t.shots(ShotOutcome::kSaved); }},
    {"/shots/blocked", [](T t) -> Json { return t.shots(ShotOutcome::kBlocked); }},
    {"/shots/wide", [](T t) -> Json { return t.shots(ShotOutcome::kWide); }},
    {"/shots/post", [](T t) -> Json { return t.shots(ShotOutcome::kPost); }},
    {"/shots/other", [](T t) -> Json { return t.shots(ShotOutcome::kOther); }},
    {"/shots/expected_goals", [](T t) -> Json { return t.totals.shots.expected; }},
    {"/shots/expected_goals_by_chain",
     [](T t) -> Json { return t.totals.shots.expected_by_chain; }},
    {"/own_goals", [](T t) -> Json { return t.totals.own_goals; }},
    {"/threat_added", [](T t) -> Json { return t.totals.threat; }},
    {"/tackles/tried", [](T t) -> Json { return t.totals.tackles.tried; }},
    {"/tackles/succeeded", [](T t) -> Json { return t.totals.tackles.succeeded; }},
    {"/tackles/failed", [](T t) -> Json { return t.totals.tackles.failed; }},
    {"/tackles/out_of_reach", [](T t) -> Json { return t.totals.tackles.out_of_reach; }},
    {"/tackles/effective", [](T t) -> Json { return t.totals.tackles.effective; }},
    {"/tackles/as_kick", [](T t) -> Json { return t.totals.tackles.as_kick; }},
    {"/interceptions", [](T t) -> Json { return t.totals.interceptions; }},
    {"/pressing/opponent_passes", [](T t) -> Json { return t.pressing().opponent_passes; }},
    {"/pressing/defensive_actions", [](T t) -> Json { return t.pressing().defensive_actions; }},
    {"/pressing/passes_per_action", [](T t) -> Json { return t.pressing().passes_per_action(); }},
    {"/pressing/pressure",
     [](T t) -> Json { return share(t.pressing().pressure_frames, t.pressing().opponent_frames); }},
    {"/pressing/recoveries", [](T t) -> Json { return t.pressing().recoveries; }},
    {"/pressing/losses", [](T t) -> Json { return t.pressing().losses; }},
    {"/pressing/regained", [](T t) -> Json { return t.pressing().regained; }},
    {"/pressing/regained_within_20_cycles", [](T t) -> Json { return t.pressing().regained_soon; }},
    {"/pressing/mean_cycles_to_regain", [](T t) -> Json { return t.pressing().regain_cycles; }},
    {"/territory/thirds_owned", [](T t) { return shares_json(t.territory().thirds_owned); }},
    {"/territory/box_entries", [](T t) -> Json { return t.territory().box_entries; }},
    {"/territory/box_touches", [](T t) -> Json { return t.territory().box_touches; }},
    {"/territory/final_third_touches",
     [](T t) -> Json { return t.territory().final_third_touches; }},
    {"/territory/pitch_control", [](T t) -> Json { return t.territory().pitch_control; }},
    {"/stoppages/set_plays", [](T t) -> Json { return t.stoppages().set_plays(); }},
    {"/stoppages/kick_offs", [](T t) -> Json { return t.stoppages().kick_offs; }},
    {"/stoppages/kick_ins", [](T t) -> Json { return t.stoppages().kick_ins; }},
    {"/stoppages/corners", [](T t) -> Json { return t.stoppages().corners; }},
    {"/stoppages/goal_kicks", [](T t) -> Json { return t.stoppages().goal_kicks; }},
    {"/stoppages/free_kicks", [](T t) -> Json { return t.stoppages().free_kicks; }},
    {"/stoppages/indirect_free_kicks",
     [](T t) -> Json { return t.stoppages().indirect_free_kicks; }},
    {"/stoppages/goalie_catches", [](T t) -> Json { return t.stoppages().goalie_catches; }},
    {"/stoppages/restart_frames", [](T t) -> Json { return t.stoppages().restart_frames; }},
    {"/stoppages/offsides", [](T t) -> Json { return t.stoppages().offsides; }},
    {"/stoppages/fouls", [](T t) -> Json { return t.stoppages().fouls; }},
    {"/stoppages/back_passes", [](T t) -> Json { return t.stoppages().back_passes; }},
    {"/stoppages/free_kick_faults", [](T t) -> Json { return t.stoppages().free_kick_faults; }},
    {"/stoppages/catch_faults", [](T t) -> Json { return t.stoppages().catch_faults; }},
    {"/stoppages/illegal_defenses", [](T t) -> Json { return t.stoppages().illegal_defenses; }},
    {"/stoppages/yellow_cards", [](T t) -> Json { return t.stoppages().yellow_cards; }},
    {"/stoppages/red_cards", [](T t) -> Json { return t.stoppages().red_cards; }},
    {"/goalkeeping/catches", [](T t) -> Json { return t.goalie().catches; }},
    {"/goalkeeping/punches", [](T t) -> Json { return t.goalie().punches; }},
    {"/goalkeeping/failed_catches", [](T t) -> Json { return t.goalie().failed_catches; }},
    {"/goalkeeping/saves", [](T t) -> Json { return t.goalie().saves; }},
    {"/goalkeeping/conceded_on_target", [](T t) -> Json { return t.goalie().conceded_on_target; }},
    {"/goalkeeping/save_rate", [](T t) -> Json { return t.goalie().save_rate(); }},
    {"/goalkeeping/moves_after_catch", [](T t) -> Json { return t.goalie().moves_after_catch; }},
    {"/goalkeeping/mean_position", [](T t) { return point_json(t.goalie().mean_position); }},
    {"/goalkeeping/furthest_rush", [](T t) -> Json { return t.goalie().furthest_rush; }},
    {"/distance", [](T t) -> Json { return t.totals.distance; }},
    {"/stamina_used", [](T t) -> Json { return t.totals.stamina_used; }},
    {"/exhausted_frames", [](T t) -> Json { return t.totals.exhausted_frames; }},
    {"/shape/formation", [](T t) -> Json { return t.shape().formation; }},
    {"/shape/length", [](T t) -> Json { return t.shape().length; }},
    {"/shape/width", [](T t) -> Json { return t.shape().width; }},
    {"/shape/hull_area", [](T t) -> Json { return t.shape().hull_area; }},
    {"/shape/compactness", [](T t) -> Json { return t.shape().compactness; }},
    {"/shape/defence_x", [](T t) -> Json { return t.shape().defense_x; }},
    {"/shape/line_distance", [](T t) -> Json { return t.shape().line_distance; }},
    {"/network/density", [](T t) -> Json { return t.network().density; }},
    {"/network/top_edge", [](T t) -> Json { return t.network().top_edge; }},
    {"/network/entropy", [](T t) -> Json { return t.network().entropy; }},
    {"/network/edges", [](T t) { return edges_json(t.network()); }},
    {"/silent_steps",
     [](T t) { return t.all.responsiveness ? Json(t.totals.silent) : discarded(); }},
    {"/rejected_commands",
     [](T t) { return t.all.responsiveness ? Json(t.totals.rejected) : discarded(); }},
};

inline constexpr Field<PlayerView> kPlayerFields[] = {
    {"/side", [](P p) -> Json { return side_text(static_cast<std::int8_t>(p.slot)); }},
    {"/unum", [](P p) -> Json { return soccer::unum_of_slot(static_cast<int>(p.slot)); }},
    {"/goalie", [](P p) { return is_goalie_json(p); }},
    {"/type", [](P p) { return type_json(p); }},
    {"/frames", [](P p) -> Json { return p.attention().frames; }},
    {"/ball/touches", [](P p) -> Json { return p.ball().touches; }},
    {"/ball/passes", [](P p) -> Json { return p.ball().passes; }},
    {"/ball/completed", [](P p) -> Json { return p.ball().completed; }},
    {"/ball/pass_length",
     [](P p) -> Json {
       return p.ball().completed == 0 ? 0.0 : p.ball().pass_length / p.ball().completed;
     }},
    {"/ball/received", [](P p) -> Json { return p.ball().received; }},
    {"/ball/through_passes", [](P p) -> Json { return p.ball().through_passes; }},
    {"/ball/crosses", [](P p) -> Json { return p.ball().crosses; }},
    {"/ball/key_passes", [](P p) -> Json { return p.ball().key_passes; }},
    {"/ball/assists", [](P p) -> Json { return p.ball().assists; }},
    {"/ball/second_assists", [](P p) -> Json { return p.ball().second_assists; }},
    {"/ball/dribbles", [](P p) -> Json { return p.ball().dribbles; }},
    {"/ball/take_ons", [](P p) -> Json { return p.ball().take_ons; }},
    {"/ball/shots", [](P p) -> Json { return p.ball().shots; }},
    {"/ball/on_target", [](P p) -> Json { return p.ball().on_target; }},
    {"/ball/goals", [](P p) -> Json { return p.ball().goals; }},
    {"/ball/own_goals", [](P p) -> Json { return p.ball().own_goals; }},
    {"/ball/expected_goals", [](P p) -> Json { return p.ball().expected_goals; }},
    {"/ball/threat_added", [](P p) -> Json { return p.ball().threat; }},
    {"/ball/losses", [](P p) -> Json { return p.ball().losses; }},
    {"/tackles/tried", [](P p) -> Json { return p.tackles().tried; }},
    {"/tackles/succeeded", [](P p) -> Json { return p.tackles().succeeded; }},
    {"/tackles/failed", [](P p) -> Json { return p.tackles().failed; }},
    {"/tackles/out_of_reach", [](P p) -> Json { return p.tackles().out_of_reach; }},
    {"/tackles/effective", [](P p) -> Json { return p.tackles().effective; }},
    {"/tackles/as_kick", [](P p) -> Json { return p.tackles().as_kick; }},
    {"/interceptions", [](P p) -> Json { return p.all.pressing.interceptions[p.slot]; }},
    {"/recoveries", [](P p) -> Json { return p.all.pressing.recoveries[p.slot]; }},
    {"/fouls", [](P p) -> Json { return p.all.stoppages.fouls_by[p.slot]; }},
    {"/fouled", [](P p) -> Json { return p.all.stoppages.fouls_against[p.slot]; }},
    {"/yellow_cards", [](P p) -> Json { return p.all.stoppages.yellow_cards[p.slot]; }},
    {"/red_cards", [](P p) -> Json { return p.all.stoppages.red_cards[p.slot]; }},
    {"/movement/distance", [](P p) -> Json { return p.movement().distance(); }},
    {"/movement/live_distance", [](P p) -> Json { return p.movement().live_distance; }},
    {"/movement/top_speed", [](P p) -> Json { return p.movement().top_speed; }},
    {"/movement/stand_jog_run_sprint", [](P p) { return shares_json(p.movement().bands); }},
    {"/stamina/used", [](P p) -> Json { return p.stamina().used; }},
    {"/stamina/lowest", [](P p) -> Json { return p.stamina().lowest; }},
    {"/stamina/last", [](P p) -> Json { return p.stamina().last; }},
    {"/stamina/last_capacity",
     [](P p) {
       const double last = p.stamina().last_capacity;
       return last < 0.0 ? Json(nullptr) : Json(last);
     }},
    {"/stamina/exhausted_frames", [](P p) -> Json { return p.stamina().exhausted_frames; }},
    {"/stamina/tired_frames", [](P p) -> Json { return p.stamina().tired_frames; }},
    {"/stamina/lowered_recovery_frames",
     [](P p) -> Json { return p.stamina().lowered_recovery_frames; }},
    {"/stamina/lowered_effort_frames",
     [](P p) -> Json { return p.stamina().lowered_effort_frames; }},
    {"/stamina/refills", [](P p) -> Json { return p.stamina().refills; }},
    {"/position/mean", [](P p) { return point_json(p.position().all.mean); }},
    {"/position/mean_own_ball", [](P p) { return point_json(p.position().mean_own_ball); }},
    {"/position/mean_opponent_ball",
     [](P p) { return point_json(p.position().mean_opponent_ball); }},
    {"/position/variance",
     [](P p) -> Json {
       const auto& all = p.position().all;
       return {all.var_x, all.var_y, all.cov_xy};
     }},
    {"/heat", [](P p) -> Json { return p.position().heat; }},
    {"/network/partners", [](P p) -> Json { return p.node().partners; }},
    {"/network/page_rank", [](P p) -> Json { return p.node().page_rank; }},
    {"/network/betweenness", [](P p) -> Json { return p.node().betweenness; }},
    {"/network/clustering", [](P p) -> Json { return p.node().clustering; }},
    {"/network/mean_contact", [](P p) { return point_json(p.node().mean_contact); }},
    {"/attention/view_narrow", [](P p) -> Json { return p.attentive(p.attention().narrow); }},
    {"/attention/view_normal", [](P p) -> Json { return p.attentive(p.attention().normal); }},
    {"/attention/view_wide", [](P p) -> Json { return p.attentive(p.attention().wide); }},
    {"/attention/view_low_quality",
     [](P p) -> Json { return p.attentive(p.attention().low_quality); }},
    {"/attention/mean_view_width", [](P p) -> Json { return p.attention().mean_view_width; }},
    {"/attention/pointing", [](P p) -> Json { return p.attentive(p.attention().pointing); }},
    {"/attention/attentive", [](P p) -> Json { return p.attentive(p.attention().attentive); }},
    {"/attention/attention_to", [](P p) { return targets_json(p.attention()); }},
    {"/counted", [](P p) { return counters_json(p.attention().counted); }},
    {"/responsiveness", [](P p) { return responsiveness_json(p); }},
    {"/rating/total", [](P p) -> Json { return p.rating().total(); }},
    {"/rating/attack", [](P p) -> Json { return p.rating().attack; }},
    {"/rating/passing", [](P p) -> Json { return p.rating().passing; }},
    {"/rating/defence", [](P p) -> Json { return p.rating().defense; }},
    {"/rating/discipline", [](P p) -> Json { return p.rating().discipline; }},
};

}  // namespace field_rows

using field_rows::kPlayerFields;
using field_rows::kTeamFields;

/// True for the path of a row, and for paths below it.
template <class Rows>
constexpr bool has_path(const Rows& rows, std::string_view path) {
  for (const auto& row : rows) {
    if (path.starts_with(row.path) &&
        (path.size() == row.path.size() || path[row.path.size()] == '/')) {
      return true;
    }
  }
  return false;
}

/// The path of a statistic of a team; an unknown one does not compile.
struct TeamPath {
  const char* text;
  consteval TeamPath(const char* path) : text(path) {
    if (!has_path(kTeamFields, path)) throw "no statistic of a team has this path";
  }
};

/// The path of a statistic of a player; an unknown one does not compile.
struct PlayerPath {
  const char* text;
  consteval PlayerPath(const char* path) : text(path) {
    if (!has_path(kPlayerFields, path)) throw "no statistic of a player has this path";
  }
};

}  // namespace cls::analysis
