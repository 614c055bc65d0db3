// One object an event.
#include "analysis/statistics/event_json.h"

#include <algorithm>
#include <utility>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/event_list.h"
#include "soccer/side_name.h"

namespace cls::analysis {
namespace {

// What led to the shot: passes of its chain and where that began.
void add_origin(const MatchStatistics& all, const Shot& shot, Json& json) {
  json["shot_distance"] = rounded(shot.distance);
  json["shot_cycles"] = rounded(shot.cycles);
  const auto chain = std::find_if(all.chains.begin(), all.chains.end(), [&](const Chain& c) {
    return c.first_touch <= shot.touch && shot.touch <= c.last_touch;
  });
  json["chain_passes"] = chain == all.chains.end() ? Json(nullptr) : Json(chain->passes);
  json["from_set_play"] = chain != all.chains.end() && chain->from_set_play;
}

// As if normal time were ninety minutes.
Json minute_json(const gamelog::MatchRecord& record, int cycle) {
  const double half = half_time_cycles(record.server);
  return half > 0.0 ? Json(rounded(45.0 * cycle / half)) : Json(nullptr);
}

void add_pass(const Pass& pass, Json& json) {
  json["speed"] = rounded(pass.speed);
  json["length"] = rounded(pass.length());
  json["gain"] = rounded(pass.gain());
  json["frames"] = pass.frames;
  if (!pass.completed()) return;
  json["nearest_opponent"] = rounded(pass.nearest_opponent);
  json["overtaken"] = pass.overtaken;
}

}  // namespace

Json goals_json(const MatchStatistics& all) {
  Json list = Json::array();
  for (std::size_t i = 0; i < all.goals.size(); ++i) {
    const Goal& goal = all.goals[i];
    Json json = {{"cycle", goal.cycle},
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
    if (goal.shot >= 0) add_origin(all, all.shots[static_cast<std::size_t>(goal.shot)], json);
    list.push_back(json);
  }
  return list;
}

Json shot_list_json(const MatchStatistics& all) {
  Json list = Json::array();
  for (std::size_t i = 0; i < all.shots.size(); ++i) {
    const Shot& shot = all.shots[i];
    const Touch& touch = all.flow.touches[shot.touch];
    const auto slot = static_cast<std::size_t>(shot.slot);
    list.push_back({{"cycle", all.flow.record->time[touch.frame]},
                    {"side", side_word(slot)},
                    {"unum", unum_of(slot)},
                    {"from", point_json(touch.contact)},
                    {"distance", rounded(shot.distance)},
                    {"speed", rounded(shot.speed)},
                    {"goal_y", rounded(shot.goal_y)},
                    {"cycles", rounded(shot.cycles)},
                    {"on_target", shot.on_target},
                    {"outcome", name(shot.outcome)},
                    {"expected_goals", rounded(all.expected[i])}});
  }
  return list;
}

Json events_json(const MatchStatistics& all) {
  Json list = Json::array();
  for (const Event& event : events_of(all)) {
    Json json = {
        {"cycle", event.cycle},
        {"stopped", event.stopped},
        {"kind", event.kind},
        {"side", event.slot == kNobody ? Json(nullptr)
                                       : Json(side_word(static_cast<std::size_t>(event.slot)))},
        {"unum", unum_or_null(event.slot)},
        {"from", point_json(event.from)},
        {"to", point_json(event.to)},
        {"other", unum_or_null(event.other)},
        {"result", event.result}};
    if (event.pass >= 0) add_pass(all.passes[static_cast<std::size_t>(event.pass)], json);
    json["marks"] = event.marks;
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace cls::analysis
