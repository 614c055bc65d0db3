// Teams, players and events of a match as JSON objects.
#include "analysis/statistics/statistics_json.h"

#include <nlohmann/json.hpp>

#include "analysis/results/results_json.h"
#include "analysis/statistics/event_json.h"
#include "analysis/statistics/json_values.h"
#include "analysis/statistics/team_totals.h"

namespace cls::analysis {
namespace {

template <typename Values>
Json shares_json(const Values& values) {
  int sum = 0;
  for (const int value : values) sum += value;
  Json list = Json::array();
  for (const int value : values) list.push_back(share(value, sum));
  return list;
}

Json possession_json(const Possession& p, std::size_t team) {
  const auto part = [team](const PerTeam<int>& frames) {
    const double left = left_share(frames);
    return rounded(team == 0 ? left : 1.0 - left);
  };
  return {{"last_touch", part(p.last_touch)}, {"next_kicker", part(p.next_kicker)},
          {"at_feet", part(p.at_feet)},       {"fastest", part(p.fastest)},
          {"all_play", part(p.all_play)},     {"last_touch_frames", p.last_touch[team]},
          {"at_feet_frames", p.at_feet[team]}};
}

Json passes_json(const PassTotals& t) {
  return {{"attempted", t.attempted},
          {"completed", t.completed},
          {"completion", share(t.completed, t.attempted)},
          {"mean_length", rounded(t.mean_length)},
          {"forward", t.directions[0]},
          {"left", t.directions[1]},
          {"right", t.directions[2]},
          {"back", t.directions[3]},
          {"intercepted", t.outcomes[static_cast<std::size_t>(PassOutcome::kIntercepted)]},
          {"contested", t.outcomes[static_cast<std::size_t>(PassOutcome::kContested)]},
          {"out", t.outcomes[static_cast<std::size_t>(PassOutcome::kOut)]},
          {"offside", t.outcomes[static_cast<std::size_t>(PassOutcome::kOffside)]},
          {"stopped", t.outcomes[static_cast<std::size_t>(PassOutcome::kStopped)]},
          {"through", t.through},
          {"crosses", t.crosses},
          {"switches", t.switches},
          {"cutbacks", t.cutbacks},
          {"clearances", t.clearances},
          {"one_twos", t.one_twos},
          {"overtaken", t.overtaken}};
}

Json shots_json(const ShotTotals& t) {
  Json json = {{"total", t.total}, {"on_target", t.on_target}};
  for (std::size_t i = 0; i < t.outcomes.size(); ++i) {
    json[std::string(name(static_cast<ShotOutcome>(i)))] = t.outcomes[i];
  }
  json["expected_goals"] = rounded(t.expected);
  json["expected_goals_by_chain"] = rounded(t.expected_by_chain);
  return json;
}

Json tackles_json(const Tackles& t) {
  return {{"tried", t.tried},         {"succeeded", t.succeeded},
          {"failed", t.failed},       {"out_of_reach", t.out_of_reach},
          {"effective", t.effective}, {"as_kick", t.as_kick}};
}

Json territory_json(const TeamTerritory& t) {
  return {{"thirds_owned", shares_json(t.thirds_owned)},
          {"box_entries", t.box_entries},
          {"box_touches", t.box_touches},
          {"final_third_touches", t.final_third_touches},
          {"pitch_control", rounded(t.pitch_control)}};
}

Json stoppages_json(const TeamStoppages& s) {
  return {{"set_plays", s.set_plays()},
          {"kick_offs", s.kick_offs},
          {"kick_ins", s.kick_ins},
          {"corners", s.corners},
          {"goal_kicks", s.goal_kicks},
          {"free_kicks", s.free_kicks},
          {"indirect_free_kicks", s.indirect_free_kicks},
          {"goalie_catches", s.goalie_catches},
          {"restart_frames", s.restart_frames},
          {"offsides", s.offsides},
          {"fouls", s.fouls},
          {"back_passes", s.back_passes},
          {"free_kick_faults", s.free_kick_faults},
          {"catch_faults", s.catch_faults},
          {"illegal_defenses", s.illegal_defenses},
          {"yellow_cards", s.yellow_cards},
          {"red_cards", s.red_cards}};
}

Json goalkeeping_json(const Goalkeeping& g) {
  return {{"catches", g.catches},
          {"punches", g.punches},
          {"failed_catches", g.failed_catches},
          {"saves", g.saves},
          {"conceded_on_target", g.conceded_on_target},
          {"save_rate", rounded(g.save_rate())},
          {"moves_after_catch", g.moves_after_catch},
          {"mean_position", point_json(g.mean_position)},
          {"furthest_rush", rounded(g.furthest_rush)}};
}

Json pressing_json(const Pressing& p) {
  return {{"opponent_passes", p.opponent_passes},
          {"defensive_actions", p.defensive_actions},
          {"passes_per_action", rounded(p.passes_per_action())},
          {"pressure", share(p.pressure_frames, p.opponent_frames)},
          {"recoveries", p.recoveries},
          {"losses", p.losses},
          {"regained", p.regained},
          {"regained_within_20_cycles", p.regained_soon},
          {"mean_cycles_to_regain", rounded(p.regain_cycles)}};
}

Json shape_json(const TeamShape& s) {
  return {{"formation", s.formation},
          {"length", rounded(s.length)},
          {"width", rounded(s.width)},
          {"hull_area", rounded(s.hull_area)},
          {"compactness", rounded(s.compactness)},
          {"defence_x", rounded(s.defence_x)},
          {"line_distance", rounded(s.line_distance)}};
}

// Edges that were used, as [from, to, passes, mean length, mean gain, threat added].
Json network_json(const PassNetwork& n) {
  Json edges = Json::array();
  for (std::size_t from = 0; from < kTeamSize; ++from) {
    for (std::size_t to = 0; to < kTeamSize; ++to) {
      const PassEdge& edge = n.edges[from][to];
      if (edge.passes == 0) continue;
      edges.push_back({from + 1, to + 1, edge.passes, rounded(edge.length), rounded(edge.gain),
                       rounded(edge.threat)});
    }
  }
  return {{"density", rounded(n.density)},
          {"top_edge", rounded(n.top_edge)},
          {"entropy", rounded(n.entropy)},
          {"edges", edges}};
}

Json chains_json(const ChainTotals& t) {
  Json results;
  for (std::size_t i = 0; i < t.results.size(); ++i) {
    results[std::string(name(static_cast<ChainResult>(i)))] = t.results[i];
  }
  return {{"count", t.count},
          {"mean_passes", rounded(t.mean_passes)},
          {"mean_frames", rounded(t.mean_frames)},
          {"from_set_play", t.from_set_play},
          {"results", results}};
}

Json team_json(const MatchSummary& summary, const MatchStatistics& all, std::size_t team) {
  const TeamTotals totals = totals_of(all, team);
  Json json;
  json["name"] = summary.teams[team].name;
  json["score"] = summary.teams[team].score;
  json["possession"] = possession_json(all.possession, team);
  json["touches"] = totals.touches;
  json["passes"] = passes_json(totals.passes);
  json["chains"] = chains_json(totals.chains);
  json["carries"] = totals.carries;
  json["dribbles"] = totals.dribbles;
  json["take_ons"] = totals.take_ons;
  json["shots"] = shots_json(totals.shots);
  json["own_goals"] = totals.own_goals;
  json["threat_added"] = rounded(totals.threat);
  json["tackles"] = tackles_json(totals.tackles);
  json["interceptions"] = totals.interceptions;
  json["pressing"] = pressing_json(all.pressing.teams[team]);
  json["territory"] = territory_json(all.territory.teams[team]);
  json["stoppages"] = stoppages_json(all.stoppages.teams[team]);
  json["goalkeeping"] = goalkeeping_json(all.goalkeeping[team]);
  json["distance"] = rounded(totals.distance);
  json["stamina_used"] = rounded(totals.stamina_used);
  json["exhausted_frames"] = totals.exhausted_frames;
  json["shape"] = shape_json(all.positions.teams[team]);
  json["network"] = network_json(all.networks[team]);
  if (all.responsiveness) {
    json["silent_steps"] = totals.silent;
    json["rejected_commands"] = totals.rejected;
  }
  return json;
}

Json work_json(const BallWork& w) {
  return {{"touches", w.touches},
          {"passes", w.passes},
          {"completed", w.completed},
          {"pass_length", rounded(w.completed == 0 ? 0.0 : w.pass_length / w.completed)},
          {"received", w.received},
          {"through_passes", w.through_passes},
          {"crosses", w.crosses},
          {"key_passes", w.key_passes},
          {"assists", w.assists},
          {"second_assists", w.second_assists},
          {"dribbles", w.dribbles},
          {"take_ons", w.take_ons},
          {"shots", w.shots},
          {"on_target", w.on_target},
          {"goals", w.goals},
          {"own_goals", w.own_goals},
          {"expected_goals", rounded(w.expected_goals)},
          {"threat_added", rounded(w.threat)},
          {"losses", w.losses}};
}

Json movement_json(const Movement& m) {
  return {{"distance", rounded(m.distance())},
          {"live_distance", rounded(m.live_distance)},
          {"top_speed", rounded(m.top_speed)},
          {"stand_jog_run_sprint", shares_json(m.bands)}};
}

Json stamina_json(const Stamina& s) {
  return {{"used", rounded(s.used)},
          {"lowest", rounded(s.lowest)},
          {"last", rounded(s.last)},
          {"last_capacity", s.last_capacity < 0.0 ? Json(nullptr) : Json(rounded(s.last_capacity))},
          {"exhausted_frames", s.exhausted_frames},
          {"tired_frames", s.tired_frames},
          {"lowered_recovery_frames", s.lowered_recovery_frames},
          {"lowered_effort_frames", s.lowered_effort_frames},
          {"refills", s.refills}};
}

Json position_json(const Positions& p) {
  return {{"mean", point_json(p.all.mean)},
          {"mean_own_ball", point_json(p.mean_own_ball)},
          {"mean_opponent_ball", point_json(p.mean_opponent_ball)},
          {"variance", {rounded(p.all.var_x), rounded(p.all.var_y), rounded(p.all.cov_xy)}}};
}

Json attention_json(const Attention& a) {
  Json targets;
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    if (a.targets[slot] == 0) continue;
    targets[std::string(1, team_of(slot) == 0 ? 'l' : 'r') + std::to_string(unum_of(slot))] =
        share(a.targets[slot], a.frames);
  }
  return {{"view_narrow", share(a.narrow, a.frames)},
          {"view_normal", share(a.normal, a.frames)},
          {"view_wide", share(a.wide, a.frames)},
          {"view_low_quality", share(a.low_quality, a.frames)},
          {"mean_view_width", rounded(a.mean_view_width)},
          {"pointing", share(a.pointing, a.frames)},
          {"attentive", share(a.attentive, a.frames)},
          {"attention_to", targets.is_null() ? Json::object() : targets}};
}

Json counted_json(const gamelog::Counters& counters) {
  Json json;
  for (std::size_t i = 0; i < gamelog::kCounterCount; ++i) {
    json[std::string(name(static_cast<gamelog::Counter>(i)))] = counters[i];
  }
  return json;
}

Json responsiveness_json(const Responsiveness& r) {
  Json commands = Json::object();
  for (std::size_t i = 0; i < gamelog::kCommandKindCount; ++i) {
    if (r.commands[i] == 0) continue;
    commands[std::string(name(static_cast<gamelog::CommandKind>(i)))] = r.commands[i];
  }
  return {{"steps", r.steps},
          {"answered", r.answered},
          {"silent", r.silent},
          {"no_body_command", r.no_body_command},
          {"several_body_commands", r.several_body},
          {"slips", r.slips},
          {"rejected_kicks", r.rejected_kicks},
          {"rejected_tackles", r.rejected_tackles},
          {"rejected_turn_necks", r.rejected_turn_necks},
          {"intentional_fouls", r.intentional_fouls},
          {"say_characters", r.say_characters},
          {"datagrams", r.datagrams},
          {"commands", commands}};
}

Json node_json(const PassNode& n) {
  return {{"partners", n.partners},
          {"page_rank", rounded(n.page_rank)},
          {"betweenness", rounded(n.betweenness)},
          {"clustering", rounded(n.clustering)},
          {"mean_contact", point_json(n.mean_contact)}};
}

Json player_json(const MatchStatistics& all, std::size_t slot) {
  const gamelog::MatchRecord& record = *all.flow.record;
  Json json;
  json["side"] = side_word(slot);
  json["unum"] = unum_of(slot);
  const std::size_t last = record.frames() == 0 ? 0 : entry_of(record.frames() - 1, slot);
  json["goalie"] = record.frames() > 0 && is_goalie(record, last);
  json["type"] = record.frames() > 0 ? Json(record.players.type[last]) : Json(nullptr);
  json["frames"] = all.attention[slot].frames;
  json["ball"] = work_json(all.ball_work[slot]);
  json["tackles"] = tackles_json(all.tackles[slot]);
  json["interceptions"] = all.pressing.interceptions[slot];
  json["recoveries"] = all.pressing.recoveries[slot];
  json["fouls"] = all.stoppages.fouls_by[slot];
  json["fouled"] = all.stoppages.fouls_against[slot];
  json["yellow_cards"] = all.stoppages.yellow_cards[slot];
  json["red_cards"] = all.stoppages.red_cards[slot];
  json["movement"] = movement_json(all.movement[slot]);
  json["stamina"] = stamina_json(all.stamina[slot]);
  json["position"] = position_json(all.positions.players[slot]);
  json["heat"] = all.positions.players[slot].heat;
  json["network"] = node_json(all.networks[team_of(slot)].nodes[slot % kTeamSize]);
  json["attention"] = attention_json(all.attention[slot]);
  json["counted"] = counted_json(all.attention[slot].counted);
  if (all.responsiveness) json["responsiveness"] = responsiveness_json((*all.responsiveness)[slot]);
  const Rating& rating = all.ratings[slot];
  json["rating"] = {{"total", rounded(rating.total())},
                    {"attack", rounded(rating.attack)},
                    {"passing", rounded(rating.passing)},
                    {"defence", rounded(rating.defence)},
                    {"discipline", rounded(rating.discipline)}};
  return json;
}

Json game_json(const MatchStatistics& all) {
  const Territory& t = all.territory;
  return {{"frames", t.frames},
          {"live_frames", t.live_frames},
          {"dead_time", share(t.frames - t.live_frames, t.frames)},
          {"ball_thirds", shares_json(t.thirds)},
          {"ball_quarters", shares_json(t.quarters)},
          {"mean_ball_x", rounded(t.mean_ball_x)},
          {"field_tilt", rounded(t.field_tilt())},
          {"dropped_balls", all.flow.placed.size()},
          {"at_feet_contested", all.possession.at_feet_contested},
          {"ball_heat", all.positions.ball}};
}

}  // namespace

std::string statistics_json(const MatchSummary& summary, const MatchStatistics& all, bool events) {
  Json json;
  json["file"] = summary.file;
  json["text_log"] = summary.text_log.empty() ? Json(nullptr) : Json(summary.text_log);
  const std::string_view winner = winner_word(summary.winner);
  json["winner"] = winner.empty() ? Json(nullptr) : Json(winner);
  json["cycles"] = summary.cycles;
  json["complete"] = summary.complete;
  json["damage"] = summary.damage;
  json["doubts"] = doubts_about(summary, all);
  json["game"] = game_json(all);
  json["left"] = team_json(summary, all, 0);
  json["right"] = team_json(summary, all, 1);
  json["goals"] = goals_json(all);
  json["shots"] = shot_list_json(all);
  json["players"] = Json::array();
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    json["players"].push_back(player_json(all, slot));
  }
  if (events) json["events"] = events_json(all);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string statistics_document(const std::vector<std::string>& matches) {
  std::string text = "{\"schema\":\"cls.stats/1\",\"matches\":[";
  for (std::size_t i = 0; i < matches.size(); ++i) text += (i > 0 ? ",\n" : "\n") + matches[i];
  return text + "\n]}\n";
}

}  // namespace cls::analysis
