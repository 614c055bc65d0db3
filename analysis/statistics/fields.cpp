// Values of the statistics that have several parts, and the objects of all.
#include "analysis/statistics/fields.h"

#include <cmath>
#include <string>

#include "analysis/statistics/field_table.h"
#include "base/text/split.h"

namespace cls::analysis {
namespace {

// An object with a member for each row that has a path and a value.
template <class View>
Json object_of(const auto& rows, const View& view) {
  Json object;
  for (const Field<View>& row : rows) {
    if (!row.path.starts_with('/')) continue;
    const std::optional<Json> value = row.value(view);
    if (!value) continue;

    Json* member = &object;
    for (const std::string_view key : base::split(row.path.substr(1), '/'))
      member = &(*member)[key];
    *member = *value;
  }
  return object;
}

}  // namespace

// Used edges as [from, to, passes, mean length, mean gain, threat added].
Json edges_json(const PassNetwork& network) {
  Json edges = Json::array();
  for (std::size_t from = 0; from < kTeamSize; ++from) {
    for (std::size_t to = 0; to < kTeamSize; ++to) {
      const PassEdge& edge = network.edges[from][to];
      if (edge.passes == 0) continue;
      edges.push_back({from + 1, to + 1, edge.passes, edge.length, edge.gain, edge.threat});
    }
  }
  return edges;
}

Json targets_json(const Attention& attention) {
  Json targets = Json::object();
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    if (attention.targets[slot] == 0) continue;
    targets[soccer::letter(side_of(slot)) + std::to_string(unum_of(slot))] =
        share(attention.targets[slot], attention.frames);
  }
  return targets;
}

Json counters_json(const gamelog::Counters& counters) {
  Json json;
  for (std::size_t i = 0; i < gamelog::kCounterCount; ++i) {
    json[name(static_cast<gamelog::Counter>(i))] = counters[i];
  }
  return json;
}

std::optional<Json> commands_json(const PlayerView& player) {
  if (!player.all.responsiveness) return std::nullopt;

  Json commands = Json::object();
  const auto& sent = (*player.all.responsiveness)[player.slot].commands;
  for (std::size_t i = 0; i < gamelog::kCommandKindCount; ++i) {
    if (sent[i] != 0) commands[name(static_cast<gamelog::CommandKind>(i))] = sent[i];
  }
  return commands;
}

Json PlayerView::type() const {
  const gamelog::MatchRecord& record = *all.flow.record;
  const std::size_t frames = record.frames();
  return frames > 0 ? Json(record.players.type[entry_of(frames - 1, slot)]) : Json();
}

Json team_fields(const MatchSummary& summary, const MatchStatistics& all, std::size_t team) {
  return object_of(kTeamFields, TeamView{summary, all, team});
}

Json player_fields(const MatchSummary& summary, const MatchStatistics& all, std::size_t slot) {
  return object_of(kPlayerFields, PlayerView{summary, all, slot});
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

const char* side_text(int slot) { return slot == kNoPlayer ? "" : side_name(side_of(slot)); }

double rounded(double value) { return std::round(value * 1e4) / 1e4 + 0.0; }

Json rounded(const Json& value) {
  if (value.is_number_float()) return rounded(value.get<double>());
  if (value.is_primitive()) return value;

  Json result = value.is_array() ? Json::array() : Json::object();
  if (value.is_array()) {
    for (const Json& element : value) result.push_back(rounded(element));
  } else {
    for (const auto& [key, member] : value.items()) result[key] = rounded(member);
  }
  return result;
}

}  // namespace cls::analysis
