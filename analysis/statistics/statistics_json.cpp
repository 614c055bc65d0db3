// Assembles the JSON document; lists goals, shots and events.
#include "analysis/statistics/statistics_json.h"

#include <algorithm>
#include <utility>

#include "analysis/statistics/event_list.h"
#include "analysis/statistics/fields.h"
#include "base/text/json_text.h"
#include "soccer/side.h"

namespace cls::analysis {
namespace {

Json unum_or_null(std::int8_t slot) { return slot == kNoPlayer ? Json() : Json(unum_of(slot)); }

// Adds the origin of a goal: its shot, and the passes and start of its chain.
void add_origin(const MatchStatistics& all, const Shot& shot, Json& json) {
  json["shot_distance"] = shot.distance;
  json["shot_cycles"] = shot.cycles;
  const Chain* chain = chain_of(all.chains, shot);
  json["chain_passes"] = chain == nullptr ? Json(nullptr) : Json(chain->passes);
  json["from_set_play"] = chain != nullptr && chain->from_set_play;
}

// Minute of play, as if normal time had 90 minutes.
Json minute_json(const gamelog::MatchRecord& record, int cycle) {
  const double half = half_time_cycles(record.server);
  return half > 0.0 ? Json(45.0 * cycle / half) : Json(nullptr);
}

void add_pass(const Pass& pass, Json& json) {
  json["speed"] = pass.speed;
  json["length"] = pass.length();
  json["gain"] = pass.gain();
  json["frames"] = pass.frames;
  if (!pass.completed()) return;
  json["nearest_opponent"] = pass.nearest_opponent;
  json["overtaken"] = pass.overtaken;
}

Json goals_json(const MatchStatistics& all) {
  Json list = Json::array();
  for (std::size_t i = 0; i < all.goals.size(); ++i) {
    const Goal& goal = all.goals[i];
    Json json = {{"cycle", goal.cycle},
                 {"frame", goal.frame},
                 {"minute", minute_json(*all.flow.record, goal.cycle)},
                 {"side", side_name(goal.side)},
                 {"unum", unum_or_null(goal.scorer)},
                 {"own_goal", goal.own_goal},
                 {"assist", unum_or_null(all.assists[i].passer)},
                 {"second_assist", unum_or_null(all.assists[i].second)},
                 {"shot_distance", nullptr},
                 {"shot_cycles", nullptr},
                 {"chain_passes", nullptr},
                 {"from_set_play", nullptr}};

    if (goal.shot >= 0) add_origin(all, all.shots[base::index(goal.shot)], json);
    list.push_back(json);
  }
  return list;
}

Json shot_list_json(const MatchStatistics& all) {
  Json list = Json::array();
  for (std::size_t i = 0; i < all.shots.size(); ++i) {
    const Shot& shot = all.shots[i];
    const Touch& touch = all.flow.touches[shot.touch];

    list.push_back({{"cycle", all.flow.record->time[touch.frame]},
                    {"frame", touch.frame},
                    {"side", side_text(shot.slot)},
                    {"unum", unum_or_null(shot.slot)},
                    {"from", point_json(touch.contact)},
                    {"distance", shot.distance},
                    {"speed", shot.speed},
                    {"goal_y", shot.goal_y},
                    {"cycles", shot.cycles},
                    {"on_target", shot.on_target},
                    {"outcome", name(shot.outcome)},
                    {"expected_goals", all.expected[i]}});
  }
  return list;
}

Json events_json(const MatchStatistics& all) {
  Json list = Json::array();
  for (const Event& event : list_events(all)) {
    Json json = {{"cycle", event.cycle},
                 {"stopped", event.stopped},
                 {"frame", event.frame},
                 {"kind", name(event.kind)},
                 {"side", event.slot == kNoPlayer ? Json(nullptr) : Json(side_text(event.slot))},
                 {"unum", unum_or_null(event.slot)},
                 {"from", point_json(event.from)},
                 {"to", point_json(event.to)},
                 {"other", unum_or_null(event.other)},
                 {"result", event.result}};
    if (event.kind == EventKind::kPass) add_pass(all.passes[event.index], json);
    json["marks"] = event.marks;
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace

std::string statistics_json(const MatchSummary& summary, const MatchStatistics& all, bool events) {
  Json json;
  json["file"] = summary.file;
  json["text_log"] = summary.text_log.empty() ? Json(nullptr) : Json(summary.text_log);
  const std::string_view winner = winner_name(summary.winner);
  json["winner"] = winner.empty() ? Json(nullptr) : Json(winner);
  json["cycles"] = summary.cycles;
  json["complete"] = summary.complete;
  json["damage"] = summary.parse_errors;
  json["doubts"] = exclusion_reasons(summary, all);

  json["game"] = game_fields(all);
  json["left"] = team_fields(summary, all, 0);
  json["right"] = team_fields(summary, all, 1);
  json["goals"] = goals_json(all);
  json["shots"] = shot_list_json(all);

  json["players"] = Json::array();
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    json["players"].push_back(player_fields(summary, all, slot));
  }

  if (events) json["events"] = events_json(all);
  return base::json_line(rounded(json));
}

std::string statistics_document(const std::vector<std::string>& matches) {
  std::string text = "{\"schema\":\"cls.stats/1\",\"matches\":[";
  for (std::size_t i = 0; i < matches.size(); ++i) text += (i > 0 ? ",\n" : "\n") + matches[i];
  return text + "\n]}\n";
}

}  // namespace cls::analysis
