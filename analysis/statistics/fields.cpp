// Names and values of all statistics.
#include "analysis/statistics/fields.h"

#include <cmath>
#include <string>

#include "soccer/side.h"

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
    return team == 0 ? left_share(frames) : 1.0 - left_share(frames);
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
          {"mean_length", t.mean_length},
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
  json["expected_goals"] = t.expected;
  json["expected_goals_by_chain"] = t.expected_by_chain;
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
          {"pitch_control", t.pitch_control}};
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
          {"save_rate", g.save_rate()},
          {"moves_after_catch", g.moves_after_catch},
          {"mean_position", point_json(g.mean_position)},
          {"furthest_rush", g.furthest_rush}};
}

Json pressing_json(const Pressing& p) {
  return {{"opponent_passes", p.opponent_passes},
          {"defensive_actions", p.defensive_actions},
          {"passes_per_action", p.passes_per_action()},
          {"pressure", share(p.pressure_frames, p.opponent_frames)},
          {"recoveries", p.recoveries},
          {"losses", p.losses},
          {"regained", p.regained},
          {"regained_within_20_cycles", p.regained_soon},
          {"mean_cycles_to_regain", p.regain_cycles}};
}

Json shape_json(const TeamShape& s) {
  return {
      {"formation", s.formation},        {"length", s.length},           {"width", s.width},
      {"hull_area", s.hull_area},        {"compactness", s.compactness}, {"defence_x", s.defense_x},
      {"line_distance", s.line_distance}};
}

// Used edges as [from, to, passes, mean length, mean gain, threat added].
Json network_json(const PassNetwork& n) {
  Json edges = Json::array();
  for (std::size_t from = 0; from < kTeamSize; ++from) {
    for (std::size_t to = 0; to < kTeamSize; ++to) {
      const PassEdge& edge = n.edges[from][to];
      if (edge.passes == 0) continue;
      edges.push_back({from + 1, to + 1, edge.passes, edge.length, edge.gain, edge.threat});
    }
  }
  return {
      {"density", n.density}, {"top_edge", n.top_edge}, {"entropy", n.entropy}, {"edges", edges}};
}

Json chains_json(const ChainTotals& t) {
  Json results;
  for (std::size_t i = 0; i < t.results.size(); ++i) {
    results[std::string(name(static_cast<ChainResult>(i)))] = t.results[i];
  }
  return {{"count", t.count},
          {"mean_passes", t.mean_passes},
          {"mean_frames", t.mean_frames},
          {"from_set_play", t.from_set_play},
          {"results", results}};
}

Json ball_actions_json(const BallActions& w) {
  return {{"touches", w.touches},
          {"passes", w.passes},
          {"completed", w.completed},
          {"pass_length", w.completed == 0 ? 0.0 : w.pass_length / w.completed},
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
          {"expected_goals", w.expected_goals},
          {"threat_added", w.threat},
          {"losses", w.losses}};
}

Json movement_json(const Movement& m) {
  return {{"distance", m.distance()},
          {"live_distance", m.live_distance},
          {"top_speed", m.top_speed},
          {"stand_jog_run_sprint", shares_json(m.bands)}};
}

Json stamina_json(const Stamina& s) {
  return {{"used", s.used},
          {"lowest", s.lowest},
          {"last", s.last},
          {"last_capacity", s.last_capacity < 0.0 ? Json(nullptr) : Json(s.last_capacity)},
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
          {"variance", {p.all.var_x, p.all.var_y, p.all.cov_xy}}};
}

Json attention_json(const Attention& a) {
  Json targets;
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    if (a.targets[slot] == 0) continue;
    targets[std::string(1, team_of(slot) == 0 ? 'l' : 'r') +
            std::to_string(soccer::unum_of_slot(static_cast<int>(slot)))] =
        share(a.targets[slot], a.frames);
  }
  return {{"view_narrow", share(a.narrow, a.frames)},
          {"view_normal", share(a.normal, a.frames)},
          {"view_wide", share(a.wide, a.frames)},
          {"view_low_quality", share(a.low_quality, a.frames)},
          {"mean_view_width", a.mean_view_width},
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
          {"slips", r.late_steps},
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
          {"page_rank", n.page_rank},
          {"betweenness", n.betweenness},
          {"clustering", n.clustering},
          {"mean_contact", point_json(n.mean_contact)}};
}

}  // namespace

Json team_fields(const MatchSummary& summary, const MatchStatistics& all, const TeamTotals& totals,
                 std::size_t team) {
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
  json["threat_added"] = totals.threat;
  json["tackles"] = tackles_json(totals.tackles);
  json["interceptions"] = totals.interceptions;
  json["pressing"] = pressing_json(all.pressing.teams[team]);
  json["territory"] = territory_json(all.territory.teams[team]);
  json["stoppages"] = stoppages_json(all.stoppages.teams[team]);
  json["goalkeeping"] = goalkeeping_json(all.goalkeeping[team]);
  json["distance"] = totals.distance;
  json["stamina_used"] = totals.stamina_used;
  json["exhausted_frames"] = totals.exhausted_frames;
  json["shape"] = shape_json(all.positions.teams[team]);
  json["network"] = network_json(all.networks[team]);
  if (all.responsiveness) {
    json["silent_steps"] = totals.silent;
    json["rejected_commands"] = totals.rejected;
  }
  return json;
}

Json player_fields(const MatchStatistics& all, std::size_t slot) {
  const gamelog::MatchRecord& record = *all.flow.record;
  Json json;
  json["side"] = side_text(static_cast<std::int8_t>(slot));
  json["unum"] = soccer::unum_of_slot(static_cast<int>(slot));
  const std::size_t last = record.frames() == 0 ? 0 : entry_of(record.frames() - 1, slot);
  json["goalie"] = record.frames() > 0 && is_goalie(record, last);
  json["type"] = record.frames() > 0 ? Json(record.players.type[last]) : Json(nullptr);
  json["frames"] = all.attention[slot].frames;
  json["ball"] = ball_actions_json(all.ball_actions[slot]);
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
  json["rating"] = {{"total", rating.total()},
                    {"attack", rating.attack},
                    {"passing", rating.passing},
                    {"defence", rating.defense},
                    {"discipline", rating.discipline}};
  return json;
}

Json game_fields(const MatchStatistics& all) {
  const Territory& t = all.territory;
  return {{"frames", t.frames},
          {"live_frames", t.live_frames},
          {"dead_time", share(t.frames - t.live_frames, t.frames)},
          {"ball_thirds", shares_json(t.thirds)},
          {"ball_quarters", shares_json(t.quarters)},
          {"mean_ball_x", t.mean_ball_x},
          {"field_tilt", t.field_tilt()},
          {"dropped_balls", all.flow.placed.size()},
          {"at_feet_contested", all.possession.at_feet_contested},
          {"ball_heat", all.positions.ball}};
}

double share(int part, int whole) { return whole == 0 ? 0.0 : 1.0 * part / whole; }

Json point_json(soccer::Vec2 p) { return Json::array({p.x, p.y}); }

const char* side_text(std::int8_t slot) {
  return slot == kNoPlayer ? "" : side_name(soccer::side_of_slot(slot));
}

double rounded(double value) { return std::round(value * 1e4) / 1e4 + 0.0; }

void round_numbers(Json& json) {
  if (json.is_number_float()) {
    json = rounded(json.get<double>());
  } else if (json.is_structured()) {
    for (Json& child : json) round_numbers(child);
  }
}

}  // namespace cls::analysis
