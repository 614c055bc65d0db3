// The one list of statistics of teams and players, from which JSON, CSV and text follow.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <type_traits>

#include "analysis/statistics/fields.h"
#include "analysis/statistics/team_totals.h"

namespace cls::analysis {

/// One team of a match.
struct TeamView {
  const MatchSummary& summary;
  const MatchStatistics& all;
  std::size_t team = 0;
  PassTotals passes = pass_totals(all, team);
  ShotTotals shots = shot_totals(all, team);
  ChainTotals chains = chain_totals(all, team);

  double part(const PerTeam<int>& frames) const {
    return team == 0 ? left_share(frames) : 1.0 - left_share(frames);
  }
  int outcome(PassOutcome outcome) const { return passes.outcomes[base::index(outcome)]; }
  int outcome(ShotOutcome outcome) const { return shots.outcomes[base::index(outcome)]; }
  int outcome(ChainResult result) const { return chains.results[base::index(result)]; }

  const TeamSummary& opponent() const { return summary.teams[1 - team]; }
  const Pressing& pressing() const { return all.pressing.teams[team]; }
  const TeamTerritory& territory() const { return all.territory.teams[team]; }
  const TeamStoppages& stoppages() const { return all.stoppages.teams[team]; }
  const Goalkeeping& goalie() const { return all.goalkeeping[team]; }
  const TeamShape& shape() const { return all.positions.teams[team]; }
  const PassNetwork& network() const { return all.networks[team]; }

  /// Sums over the players.
  auto sum(const auto& players, auto member) const {
    std::remove_cvref_t<decltype(std::invoke(member, players[0]))> total{};
    for (const std::size_t slot : kTeamSlots[team]) total += std::invoke(member, players[slot]);
    return total;
  }
  auto ball(auto member) const { return sum(all.ball_actions, member); }
  int tackles(int Tackles::*member) const { return sum(all.tackles, member); }
  int interceptions() const { return sum(all.pressing.interceptions, std::identity()); }
  std::optional<Json> sent(auto member) const {
    if (!all.responsiveness) return std::nullopt;
    return sum(*all.responsiveness, member);
  }
};

/// One player of a match.
struct PlayerView {
  const MatchSummary& summary;
  const MatchStatistics& all;
  std::size_t slot = 0;

  Json type() const;
  Json last_capacity() const {
    return stamina().last_capacity < 0.0 ? Json() : Json(stamina().last_capacity);
  }
  Json variance() const {
    const Cloud& all_play = position().all;
    return {all_play.var_x, all_play.var_y, all_play.cov_xy};
  }

  const BallActions& ball() const { return all.ball_actions[slot]; }
  const Tackles& tackles() const { return all.tackles[slot]; }
  const Movement& movement() const { return all.movement[slot]; }
  const Stamina& stamina() const { return all.stamina[slot]; }
  const Positions& position() const { return all.positions.players[slot]; }
  const PassNode& node() const { return all.networks[team_of(slot)].nodes[slot % kTeamSize]; }
  const Attention& attention() const { return all.attention[slot]; }
  double attentive(int frames) const { return share(frames, attention().frames); }
  std::optional<Json> sent(int Responsiveness::*member) const {
    if (!all.responsiveness) return std::nullopt;
    return (*all.responsiveness)[slot].*member;
  }
  const Rating& rating() const { return all.ratings[slot]; }
};

/// A statistic.
template <class View>
struct Field {
  std::string_view path;  ///< in the JSON object; without a slash in front it is not there
  std::optional<Json> (*value)(const View&);  ///< none: the match has no such value
  const char* column = nullptr;               ///< heading in the CSV table; null: it is not there
};

// Values of several parts.
Json edges_json(const PassNetwork& network);
Json targets_json(const Attention& attention);
Json counters_json(const gamelog::Counters& counters);
std::optional<Json> commands_json(const PlayerView& player);
template <typename Values>
Json shares_json(const Values& values) {
  int sum = 0;
  for (const int value : values) sum += value;
  Json list = Json::array();
  for (const int value : values) list.push_back(share(value, sum));
  return list;
}

// The value of a team t, of a player p.
#define CLS_T(...) [](const TeamView& t) -> std::optional<Json> { return __VA_ARGS__; }
#define CLS_P(...) [](const PlayerView& p) -> std::optional<Json> { return __VA_ARGS__; }

/// In the order of the members of each object, and in that of the columns.
inline constexpr Field<TeamView> kTeamFields[] = {
    {"file", CLS_T(t.summary.file), "file"},
    {"side", CLS_T(t.team == 0 ? "left" : "right"), "side"},
    {"/name", CLS_T(t.summary.teams[t.team].name), "name"},
    {"/score", CLS_T(t.summary.teams[t.team].score), "score"},

    {"opponent", CLS_T(t.opponent().name), "opponent"},
    {"opponent_score", CLS_T(t.opponent().score), "opponent_score"},
    {"cycles", CLS_T(t.summary.cycles), "cycles"},
    {"complete", CLS_T(t.summary.complete), "complete"},

    {"/possession/last_touch", CLS_T(t.part(t.all.possession.last_touch)), "possession"},
    {"/possession/next_kicker", CLS_T(t.part(t.all.possession.next_kicker))},
    {"/possession/at_feet", CLS_T(t.part(t.all.possession.at_feet)), "possession_at_feet"},
    {"/possession/fastest", CLS_T(t.part(t.all.possession.fastest)), "possession_fastest"},
    {"/possession/all_play", CLS_T(t.part(t.all.possession.all_play))},
    {"/possession/last_touch_frames", CLS_T(t.all.possession.last_touch[t.team])},
    {"/possession/at_feet_frames", CLS_T(t.all.possession.at_feet[t.team])},

    {"/touches", CLS_T(t.ball(&BallActions::touches)), "touches"},
    {"/passes/attempted", CLS_T(t.passes.attempted), "passes"},
    {"/passes/completed", CLS_T(t.passes.completed), "completed"},
    {"/passes/completion", CLS_T(share(t.passes.completed, t.passes.attempted))},
    {"/passes/mean_length", CLS_T(t.passes.mean_length), "mean_pass"},
    {"/passes/forward", CLS_T(t.passes.directions[0])},
    {"/passes/left", CLS_T(t.passes.directions[1])},
    {"/passes/right", CLS_T(t.passes.directions[2])},
    {"/passes/back", CLS_T(t.passes.directions[3])},
    {"/passes/intercepted", CLS_T(t.outcome(PassOutcome::kIntercepted))},
    {"/passes/contested", CLS_T(t.outcome(PassOutcome::kContested))},
    {"/passes/out", CLS_T(t.outcome(PassOutcome::kOut))},
    {"/passes/offside", CLS_T(t.outcome(PassOutcome::kOffside))},
    {"/passes/stopped", CLS_T(t.outcome(PassOutcome::kStopped))},
    {"/passes/through", CLS_T(t.passes.through), "through"},
    {"/passes/crosses", CLS_T(t.passes.crosses), "crosses"},
    {"/passes/switches", CLS_T(t.passes.switches)},
    {"/passes/cutbacks", CLS_T(t.passes.cutbacks)},
    {"/passes/clearances", CLS_T(t.passes.clearances)},
    {"/passes/one_twos", CLS_T(t.all.one_twos[t.team]), "one_twos"},
    {"/passes/overtaken", CLS_T(t.passes.overtaken)},

    {"/chains/count", CLS_T(t.chains.count)},
    {"/chains/mean_passes", CLS_T(t.chains.mean_passes)},
    {"/chains/mean_frames", CLS_T(t.chains.mean_frames)},
    {"/chains/from_set_play", CLS_T(t.chains.from_set_play)},
    {"/chains/results/goal", CLS_T(t.outcome(ChainResult::kGoal))},
    {"/chains/results/shot", CLS_T(t.outcome(ChainResult::kShot))},
    {"/chains/results/box_entry", CLS_T(t.outcome(ChainResult::kBoxEntry))},
    {"/chains/results/lost", CLS_T(t.outcome(ChainResult::kLost))},
    {"/chains/results/out", CLS_T(t.outcome(ChainResult::kOut))},

    {"/carries", CLS_T(std::ranges::count(t.all.carries, t.team, &Carry::team))},
    {"/dribbles", CLS_T(t.ball(&BallActions::dribbles)), "dribbles"},
    {"/take_ons", CLS_T(t.ball(&BallActions::take_ons)), "take_ons"},
    {"/shots/total", CLS_T(t.shots.total), "shots"},
    {"/shots/on_target", CLS_T(t.shots.on_target), "on_target"},
    {"goals", CLS_T(t.ball(&BallActions::goals)), "goals"},
    {"/shots/goal", CLS_T(t.outcome(ShotOutcome::kGoal))},
    {"/shots/saved", CLS_T(t.outcome(ShotOutcome::kSaved))},
    {"/shots/blocked", CLS_T(t.outcome(ShotOutcome::kBlocked))},
    {"/shots/wide", CLS_T(t.outcome(ShotOutcome::kWide))},
    {"/shots/post", CLS_T(t.outcome(ShotOutcome::kPost))},
    {"/shots/other", CLS_T(t.outcome(ShotOutcome::kOther))},
    {"/shots/expected_goals", CLS_T(t.shots.expected), "expected_goals"},
    {"/shots/expected_goals_by_chain", CLS_T(t.shots.expected_by_chain)},

    {"/own_goals", CLS_T(t.ball(&BallActions::own_goals))},
    {"/threat_added", CLS_T(t.ball(&BallActions::threat))},
    {"/tackles/tried", CLS_T(t.tackles(&Tackles::tried)), "tackles"},
    {"/tackles/succeeded", CLS_T(t.tackles(&Tackles::succeeded)), "tackles_hit"},
    {"/tackles/failed", CLS_T(t.tackles(&Tackles::failed))},
    {"/tackles/out_of_reach", CLS_T(t.tackles(&Tackles::out_of_reach))},
    {"/tackles/effective", CLS_T(t.tackles(&Tackles::effective)), "tackles_effective"},
    {"/tackles/as_kick", CLS_T(t.tackles(&Tackles::as_kick))},

    {"/interceptions", CLS_T(t.interceptions()), "interceptions"},
    {"/pressing/opponent_passes", CLS_T(t.pressing().opponent_passes)},
    {"/pressing/defensive_actions", CLS_T(t.pressing().defensive_actions)},
    {"/pressing/passes_per_action", CLS_T(t.pressing().passes_per_action())},
    {"/pressing/pressure", CLS_T(t.pressing().pressure())},
    {"/pressing/recoveries", CLS_T(t.pressing().recoveries), "recoveries"},
    {"/pressing/losses", CLS_T(t.pressing().losses)},
    {"/pressing/regained", CLS_T(t.pressing().regained)},
    {"/pressing/regained_within_20_cycles", CLS_T(t.pressing().regained_soon)},
    {"/pressing/mean_cycles_to_regain", CLS_T(t.pressing().regain_cycles)},

    {"/territory/thirds_owned", CLS_T(shares_json(t.territory().thirds_owned))},
    {"/territory/box_entries", CLS_T(t.territory().box_entries), "box_entries"},
    {"/territory/box_touches", CLS_T(t.territory().box_touches), "box_touches"},
    {"/territory/final_third_touches", CLS_T(t.territory().final_third_touches),
     "final_third_touches"},
    {"/territory/pitch_control", CLS_T(t.territory().pitch_control), "pitch_control"},

    {"/stoppages/set_plays", CLS_T(t.stoppages().set_plays())},
    {"/stoppages/kick_offs", CLS_T(t.stoppages().kick_offs)},
    {"/stoppages/kick_ins", CLS_T(t.stoppages().kick_ins)},
    {"/stoppages/corners", CLS_T(t.stoppages().corners), "corners"},

    {"kick_ins", CLS_T(t.stoppages().kick_ins), "kick_ins"},
    {"/stoppages/goal_kicks", CLS_T(t.stoppages().goal_kicks), "goal_kicks"},
    {"/stoppages/free_kicks", CLS_T(t.stoppages().free_kicks), "free_kicks"},
    {"/stoppages/indirect_free_kicks", CLS_T(t.stoppages().indirect_free_kicks),
     "indirect_free_kicks"},
    {"/stoppages/goalie_catches", CLS_T(t.stoppages().goalie_catches)},
    {"/stoppages/restart_frames", CLS_T(t.stoppages().restart_frames)},

    {"/goalkeeping/catches", CLS_T(t.goalie().catches), "catches"},
    {"/goalkeeping/punches", CLS_T(t.goalie().punches)},
    {"/goalkeeping/failed_catches", CLS_T(t.goalie().failed_catches)},
    {"/goalkeeping/saves", CLS_T(t.goalie().saves), "saves"},
    {"/goalkeeping/conceded_on_target", CLS_T(t.goalie().conceded_on_target)},
    {"/goalkeeping/save_rate", CLS_T(t.goalie().save_rate())},
    {"/goalkeeping/moves_after_catch", CLS_T(t.goalie().moves_after_catch)},
    {"/goalkeeping/mean_position", CLS_T(point_json(t.goalie().mean_position))},
    {"/goalkeeping/furthest_rush", CLS_T(t.goalie().furthest_rush)},

    {"/stoppages/offsides", CLS_T(t.stoppages().offsides), "offsides"},
    {"/stoppages/fouls", CLS_T(t.stoppages().fouls), "fouls"},
    {"/stoppages/back_passes", CLS_T(t.stoppages().back_passes)},
    {"/stoppages/free_kick_faults", CLS_T(t.stoppages().free_kick_faults)},
    {"/stoppages/catch_faults", CLS_T(t.stoppages().catch_faults)},
    {"/stoppages/illegal_defenses", CLS_T(t.stoppages().illegal_defenses)},
    {"/stoppages/yellow_cards", CLS_T(t.stoppages().yellow_cards), "yellow"},
    {"/stoppages/red_cards", CLS_T(t.stoppages().red_cards), "red"},

    {"/distance", CLS_T(t.sum(t.all.movement, &Movement::distance)), "distance"},
    {"/stamina_used", CLS_T(t.sum(t.all.stamina, &Stamina::used)), "stamina_used"},
    {"/exhausted_frames", CLS_T(t.sum(t.all.stamina, &Stamina::exhausted_frames)),
     "exhausted_frames"},

    {"/shape/formation", CLS_T(t.shape().formation)},
    {"/shape/length", CLS_T(t.shape().length)},
    {"/shape/width", CLS_T(t.shape().width)},
    {"/shape/hull_area", CLS_T(t.shape().hull_area)},
    {"/shape/compactness", CLS_T(t.shape().compactness)},
    {"/shape/defence_x", CLS_T(t.shape().defense_x)},
    {"/shape/line_distance", CLS_T(t.shape().line_distance)},

    {"/network/density", CLS_T(t.network().density)},
    {"/network/top_edge", CLS_T(t.network().top_edge)},
    {"/network/entropy", CLS_T(t.network().entropy)},
    {"/network/edges", CLS_T(edges_json(t.network()))},

    {"/silent_steps", CLS_T(t.sent(&Responsiveness::silent)), "silent_steps"},
    {"steps", CLS_T(t.sent(&Responsiveness::steps))},
    {"/rejected_commands", CLS_T(t.sent(&Responsiveness::rejected)), "rejected_commands"},
};

inline constexpr Field<PlayerView> kPlayerFields[] = {
    {"file", CLS_P(p.summary.file), "file"},
    {"/side", CLS_P(side_text(p.slot)), "side"},
    {"name", CLS_P(p.summary.teams[team_of(p.slot)].name), "name"},
    {"/unum", CLS_P(unum_of(p.slot)), "unum"},
    {"/goalie", CLS_P(was_goalie(*p.all.flow.record, p.slot))},
    {"/type", CLS_P(p.type())},
    {"/frames", CLS_P(p.attention().frames), "frames"},

    {"/ball/touches", CLS_P(p.ball().touches), "touches"},
    {"/ball/passes", CLS_P(p.ball().passes), "passes"},
    {"/ball/completed", CLS_P(p.ball().completed), "completed"},
    {"/ball/pass_length", CLS_P(p.ball().mean_pass_length())},
    {"/ball/received", CLS_P(p.ball().received), "received"},
    {"/ball/through_passes", CLS_P(p.ball().through_passes)},
    {"/ball/crosses", CLS_P(p.ball().crosses)},
    {"/ball/key_passes", CLS_P(p.ball().key_passes), "key_passes"},
    {"/ball/assists", CLS_P(p.ball().assists), "assists"},
    {"/ball/second_assists", CLS_P(p.ball().second_assists)},
    {"/ball/dribbles", CLS_P(p.ball().dribbles), "dribbles"},
    {"/ball/take_ons", CLS_P(p.ball().take_ons), "take_ons"},
    {"/ball/shots", CLS_P(p.ball().shots), "shots"},
    {"/ball/on_target", CLS_P(p.ball().on_target), "on_target"},
    {"/ball/goals", CLS_P(p.ball().goals), "goals"},
    {"/ball/own_goals", CLS_P(p.ball().own_goals), "own_goals"},
    {"/ball/expected_goals", CLS_P(p.ball().expected_goals), "expected_goals"},
    {"/ball/threat_added", CLS_P(p.ball().threat), "threat_added"},

    {"/tackles/tried", CLS_P(p.tackles().tried), "tackles"},
    {"/tackles/succeeded", CLS_P(p.tackles().succeeded), "tackles_hit"},
    {"/tackles/failed", CLS_P(p.tackles().failed)},
    {"/tackles/out_of_reach", CLS_P(p.tackles().out_of_reach)},
    {"/tackles/effective", CLS_P(p.tackles().effective)},
    {"/tackles/as_kick", CLS_P(p.tackles().as_kick)},

    {"/interceptions", CLS_P(p.all.pressing.interceptions[p.slot]), "interceptions"},
    {"/recoveries", CLS_P(p.all.pressing.recoveries[p.slot]), "recoveries"},
    {"/ball/losses", CLS_P(p.ball().losses), "losses"},
    {"/fouls", CLS_P(p.all.stoppages.fouls_by[p.slot]), "fouls"},
    {"/fouled", CLS_P(p.all.stoppages.fouls_against[p.slot]), "fouled"},
    {"/yellow_cards", CLS_P(p.all.stoppages.yellow_cards[p.slot]), "yellow"},
    {"/red_cards", CLS_P(p.all.stoppages.red_cards[p.slot]), "red"},

    {"/movement/distance", CLS_P(p.movement().distance()), "distance"},
    {"/movement/live_distance", CLS_P(p.movement().live_distance)},
    {"/movement/top_speed", CLS_P(p.movement().top_speed), "top_speed"},
    {"/movement/stand_jog_run_sprint", CLS_P(shares_json(p.movement().bands))},

    {"/stamina/used", CLS_P(p.stamina().used), "stamina_used"},
    {"/stamina/lowest", CLS_P(p.stamina().lowest), "lowest_stamina"},
    {"/stamina/last", CLS_P(p.stamina().last)},
    {"/stamina/last_capacity", CLS_P(p.last_capacity())},
    {"/stamina/exhausted_frames", CLS_P(p.stamina().exhausted_frames), "exhausted_frames"},
    {"/stamina/tired_frames", CLS_P(p.stamina().tired_frames)},
    {"/stamina/lowered_recovery_frames", CLS_P(p.stamina().lowered_recovery_frames)},
    {"/stamina/lowered_effort_frames", CLS_P(p.stamina().lowered_effort_frames)},
    {"/stamina/refills", CLS_P(p.stamina().refills)},

    {"/position/mean", CLS_P(point_json(p.position().all.mean))},
    {"mean_x", CLS_P(p.position().all.mean.x), "mean_x"},
    {"mean_y", CLS_P(p.position().all.mean.y), "mean_y"},

    {"/position/mean_own_ball", CLS_P(point_json(p.position().mean_own_ball))},
    {"/position/mean_opponent_ball", CLS_P(point_json(p.position().mean_opponent_ball))},
    {"/position/variance", CLS_P(p.variance())},

    {"/heat", CLS_P(p.position().heat)},
    {"/network/partners", CLS_P(p.node().partners)},
    {"/network/page_rank", CLS_P(p.node().page_rank)},
    {"/network/betweenness", CLS_P(p.node().betweenness)},
    {"/network/clustering", CLS_P(p.node().clustering)},
    {"/network/mean_contact", CLS_P(point_json(p.node().mean_contact))},

    {"/attention/view_narrow", CLS_P(p.attentive(p.attention().narrow))},
    {"/attention/view_normal", CLS_P(p.attentive(p.attention().normal))},
    {"/attention/view_wide", CLS_P(p.attentive(p.attention().wide))},
    {"/attention/view_low_quality", CLS_P(p.attentive(p.attention().low_quality))},
    {"/attention/mean_view_width", CLS_P(p.attention().mean_view_width)},
    {"/attention/pointing", CLS_P(p.attentive(p.attention().pointing))},
    {"/attention/attentive", CLS_P(p.attentive(p.attention().attentive))},
    {"/attention/attention_to", CLS_P(targets_json(p.attention()))},

    {"/counted", CLS_P(counters_json(p.attention().counted))},
    {"/responsiveness/steps", CLS_P(p.sent(&Responsiveness::steps)), "steps"},
    {"/responsiveness/answered", CLS_P(p.sent(&Responsiveness::answered))},
    {"/responsiveness/silent", CLS_P(p.sent(&Responsiveness::silent)), "silent"},
    {"/responsiveness/no_body_command", CLS_P(p.sent(&Responsiveness::no_body_command)),
     "no_body_command"},
    {"/responsiveness/several_body_commands", CLS_P(p.sent(&Responsiveness::several_body))},
    {"/responsiveness/slips", CLS_P(p.sent(&Responsiveness::late_steps))},
    {"/responsiveness/rejected_kicks", CLS_P(p.sent(&Responsiveness::rejected_kicks)),
     "rejected_kicks"},
    {"/responsiveness/rejected_tackles", CLS_P(p.sent(&Responsiveness::rejected_tackles))},
    {"/responsiveness/rejected_turn_necks", CLS_P(p.sent(&Responsiveness::rejected_turn_necks))},
    {"/responsiveness/intentional_fouls", CLS_P(p.sent(&Responsiveness::intentional_fouls))},
    {"/responsiveness/say_characters", CLS_P(p.sent(&Responsiveness::say_characters))},
    {"/responsiveness/datagrams", CLS_P(p.sent(&Responsiveness::datagrams))},
    {"/responsiveness/commands", CLS_P(commands_json(p))},

    {"/rating/total", CLS_P(p.rating().total()), "rating"},
    {"/rating/attack", CLS_P(p.rating().attack)},
    {"/rating/passing", CLS_P(p.rating().passing)},
    {"/rating/defence", CLS_P(p.rating().defense)},
    {"/rating/discipline", CLS_P(p.rating().discipline)},
};

#undef CLS_T
#undef CLS_P

/// A row of a table, by its path; an unknown path does not compile.
template <class View, const auto& kRows>
struct Statistic {
  const Field<View>* row = nullptr;

  constexpr Statistic() = default;
  consteval Statistic(const char* path)
      : row(std::ranges::find(kRows, std::string_view(path), &Field<View>::path)) {
    if (row == std::end(kRows)) throw "no statistic has this path";
  }
};
using TeamStatistic = Statistic<TeamView, kTeamFields>;
using PlayerStatistic = Statistic<PlayerView, kPlayerFields>;

enum class Scale : std::uint8_t { kNone, kPercent, kKilometers };

/// A figure of the text: a heading, and a format for the values of statistics.
template <class Statistic>
struct Figure {
  const char* heading;
  const char* format;
  Statistic statistics[5];
  Scale scale = Scale::kNone;
};

inline constexpr Figure<TeamStatistic> kTeamFigures[] = {
    {"possession (last touch)", "{:.1f} %", {"/possession/last_touch"}, Scale::kPercent},
    {"ball at feet", "{:.1f} %", {"/possession/at_feet"}, Scale::kPercent},
    {"fastest to the ball", "{:.1f} %", {"/possession/fastest"}, Scale::kPercent},
    {"touches", "{}", {"/touches"}},
    {"passes completed", "{} of {}", {"/passes/completed", "/passes/attempted"}},
    {"mean pass", "{:.1f} m", {"/passes/mean_length"}},
    {"through passes, crosses, one-twos",
     "{}, {}, {}",
     {"/passes/through", "/passes/crosses", "/passes/one_twos"}},
    {"dribbles, take-ons", "{}, {}", {"/dribbles", "/take_ons"}},
    {"shots on target", "{} of {}", {"/shots/on_target", "/shots/total"}},
    {"goal, saved, blocked, wide, post",
     "{}, {}, {}, {}, {}",
     {"/shots/goal", "/shots/saved", "/shots/blocked", "/shots/wide", "/shots/post"}},
    {"expected goals", "{:.2f}", {"/shots/expected_goals"}},
    {"box entries, touches in the box",
     "{}, {}",
     {"/territory/box_entries", "/territory/box_touches"}},
    {"pitch control", "{:.1f} %", {"/territory/pitch_control"}, Scale::kPercent},
    {"successful tackles", "{} of {}", {"/tackles/succeeded", "/tackles/tried"}},
    {"interceptions, recoveries", "{}, {}", {"/interceptions", "/pressing/recoveries"}},
    {"opponent passes per defensive action", "{:.1f}", {"/pressing/passes_per_action"}},
    {"saves, catches", "{}, {}", {"/goalkeeping/saves", "/goalkeeping/catches"}},
    {"offsides, fouls", "{}, {}", {"/stoppages/offsides", "/stoppages/fouls"}},
    {"yellow, red cards", "{}, {}", {"/stoppages/yellow_cards", "/stoppages/red_cards"}},
    {"kick-ins, corners, goal kicks",
     "{}, {}, {}",
     {"/stoppages/kick_ins", "/stoppages/corners", "/stoppages/goal_kicks"}},
    {"free kicks, indirect", "{}, {}", {"/stoppages/free_kicks", "/stoppages/indirect_free_kicks"}},
    {"distance", "{:.1f} km", {"/distance"}, Scale::kKilometers},
    {"formation", "{}", {"/shape/formation"}},
    {"length x width", "{:.0f} x {:.0f} m", {"/shape/length", "/shape/width"}},
    {"silent steps", "{} of {}", {"/silent_steps", "steps"}},
    {"rejected commands", "{}", {"/rejected_commands"}},
};

inline constexpr Figure<PlayerStatistic> kPlayerFigures[] = {
    {"touches", "{}", {"/ball/touches"}},
    {"passes", "{} of {}", {"/ball/completed", "/ball/passes"}},
    {"dribbles", "{}", {"/ball/dribbles"}},
    {"shots", "{} of {}", {"/ball/on_target", "/ball/shots"}},
    {"goals", "{}", {"/ball/goals"}},
    {"tackles", "{} of {}", {"/tackles/succeeded", "/tackles/tried"}},
    {"recoveries", "{}", {"/recoveries"}},
    {"losses", "{}", {"/ball/losses"}},
    {"fouls", "{}", {"/fouls"}},
    {"meters", "{:.0f}", {"/movement/distance"}},
    {"stamina", "{:.0f}", {"/stamina/used"}},
    {"silent", "{}", {"/responsiveness/silent"}},
    {"rating", "{:.1f}", {"/rating/total"}},
};

}  // namespace cls::analysis
