// Values of the statistics that have several parts, and the objects of all.
#include "analysis/statistics/fields.h"

#include <cmath>
#include <string>

#include "analysis/statistics/field_table.h"
#include "soccer/side.h"

namespace cls::analysis {
namespace {

// An object with a member for each row that has a value.
template <class Rows, class View>
Json object_of(const Rows& rows, const View& view) {
  Json object;
  for (const auto& row : rows) {
    Json value = row.value(view);
    if (!value.is_discarded()) object[Json::json_pointer(std::string(row.path))] = std::move(value);
  }
  return object;
}

}  // namespace

Json discarded() { return Json::value_t::discarded; }

Json chain_results_json(const ChainTotals& totals) {
  Json results;
  for (std::size_t i = 0; i < totals.results.size(); ++i) {
    results[std::string(name(static_cast<ChainResult>(i)))] = totals.results[i];
  }
  return results;
}

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
    targets[std::string(1, team_of(slot) == 0 ? 'l' : 'r') +
            std::to_string(soccer::unum_of_slot(static_cast<int>(slot)))] =
        share(attention.targets[slot], attention.frames);
  }
  return targets;
}

Json counters_json(const gamelog::Counters& counters) {
  Json json;
  for (std::size_t i = 0; i < gamelog::kCounterCount; ++i) {
    json[std::string(name(static_cast<gamelog::Counter>(i)))] = counters[i];
  }
  return json;
}

Json is_goalie_json(const PlayerView& player) {
  return was_goalie(*player.all.flow.record, player.slot);
}

Json type_json(const PlayerView& player) {
  const gamelog::MatchRecord& record = *player.all.flow.record;
  const std::size_t frames = record.frames();
  return frames > 0 ? Json(record.players.type[entry_of(frames - 1, player.slot)]) : Json(nullptr);
}

Json responsiveness_json(const PlayerView& player) {
  if (!player.all.responsiveness) return discarded();
  const Responsiveness& r = (*player.all.responsiveness)[player.slot];
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

Json team_fields(const MatchSummary& summary, const MatchStatistics& all, const TeamTotals& totals,
                 std::size_t team) {
  return object_of(kTeamFields, TeamView{summary, all, totals, team});
}

Json player_fields(const MatchStatistics& all, std::size_t slot) {
  return object_of(kPlayerFields, PlayerView{all, slot});
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
