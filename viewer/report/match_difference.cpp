// Compares frames, events and figures.
#include "viewer/report/match_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <tuple>

#include "analysis/statistics/event_list.h"
#include "analysis/statistics/field_table.h"
#include "analysis/statistics/fields.h"
#include "analysis/statistics/team_totals.h"
#include "soccer/side.h"

namespace cls::viewer {
namespace {

using analysis::MatchStatistics;
using gamelog::Column;
using gamelog::MatchRecord;
using gamelog::PlayerColumns;

// Logs have NaN where an arm does not point, so equal bits are equal values.
template <typename T>
bool differs(const Column<T>& a, const Column<T>& b, std::size_t at) {
  return std::memcmp(&a[at], &b[at], sizeof(T)) != 0;
}

void add_players(const MatchRecord& a, const MatchRecord& b, std::size_t frame,
                 std::vector<std::string>& what) {
  const PlayerColumns& p = a.players;
  const PlayerColumns& q = b.players;
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const std::size_t at = frame * gamelog::kSlots + slot;
    const int index = static_cast<int>(slot);
    const auto add = [&](bool different, const char* name) {
      if (!different) return;
      what.push_back(fmt::format("{} {} {}", soccer::side_name(soccer::side_of_slot(index)),
                                 soccer::unum_of_slot(index), name));
    };

    add(differs(p.position, q.position, at), "position");
    add(differs(p.velocity, q.velocity, at), "velocity");
    add(differs(p.body, q.body, at), "body");
    add(differs(p.neck, q.neck, at), "neck");
    add(differs(p.state, q.state, at), "state");
    add(differs(p.type, q.type, at), "type");
    add(differs(p.stamina, q.stamina, at) || differs(p.effort, q.effort, at) ||
            differs(p.recovery, q.recovery, at) || differs(p.capacity, q.capacity, at),
        "stamina");
    add(differs(p.view_width, q.view_width, at) || differs(p.high_quality, q.high_quality, at) ||
            differs(p.focus, q.focus, at),
        "view");
    add(differs(p.pointing_at, q.pointing_at, at) || differs(p.attention, q.attention, at),
        "attention");
    add(differs(p.counters, q.counters, at), "commands");
  }
}

std::vector<std::string> differences_at(const MatchRecord& a, const MatchRecord& b,
                                        std::size_t frame) {
  std::vector<std::string> what;
  const auto add = [&](bool different, const char* name) {
    if (different) what.emplace_back(name);
  };
  const auto score = [frame](const MatchRecord& record, std::size_t team) {
    return record.teams[record.team_state[frame]][team].score;
  };

  add(differs(a.time, b.time, frame) || differs(a.stopped, b.stopped, frame), "clock");
  add(differs(a.mode, b.mode, frame), "play mode");
  add(score(a, 0) != score(b, 0) || score(a, 1) != score(b, 1), "score");
  add(differs(a.ball_position, b.ball_position, frame), "ball position");
  add(differs(a.ball_velocity, b.ball_velocity, frame), "ball velocity");
  add(differs(a.ball_height, b.ball_height, frame), "ball height");
  add_players(a, b, frame, what);
  return what;
}

/// Cycle, kind, slot and result: equal in equal matches.
using EventKey = std::tuple<int, std::string, int, std::string>;

std::vector<EventKey> keys_of(const MatchStatistics& statistics) {
  std::vector<EventKey> keys;
  for (const analysis::Event& event : analysis::list_events(statistics)) {
    if (event.kind != "goal" && event.kind != "shot" && event.kind != "foul") continue;
    keys.emplace_back(event.cycle, std::string(event.kind), event.slot, std::string(event.result));
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

// "foul_charge_l", a play mode, is "foul charge": the player says which side.
std::string words_of(std::string name) {
  if (name.ends_with("_l") || name.ends_with("_r")) name.resize(name.size() - 2);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

void add_missing(const std::vector<EventKey>& from, const std::vector<EventKey>& in,
                 std::size_t match, std::vector<LoneEvent>& events) {
  std::vector<EventKey> lone;
  std::set_difference(from.begin(), from.end(), in.begin(), in.end(), std::back_inserter(lone));
  for (const auto& [cycle, kind, slot, result] : lone) {
    std::string text = kind;
    if (slot >= 0) {
      text += fmt::format(", {} {}", soccer::side_name(soccer::side_of_slot(slot)),
                          soccer::unum_of_slot(slot));
    }
    if (!result.empty() && result != kind) text += ": " + words_of(result);
    events.push_back({match, cycle, std::move(text)});
  }
}

/// A statistic of a team.
struct Figure {
  const char* name;
  analysis::TeamPath path;
  int decimals;
  double scale;
};

constexpr Figure kFigures[] = {
    {"goals", "/score", 0, 1.0},
    {"shots", "/shots/total", 0, 1.0},
    {"shots on target", "/shots/on_target", 0, 1.0},
    {"expected goals", "/shots/expected_goals", 2, 1.0},
    {"possession %", "/possession/last_touch", 1, 100.0},
    {"touches", "/touches", 0, 1.0},
    {"passes completed", "/passes/completed", 0, 1.0},
    {"passes attempted", "/passes/attempted", 0, 1.0},
    {"dribbles", "/dribbles", 0, 1.0},
    {"box entries", "/territory/box_entries", 0, 1.0},
    {"pitch control %", "/territory/pitch_control", 1, 100.0},
    {"successful tackles", "/tackles/succeeded", 0, 1.0},
    {"interceptions", "/interceptions", 0, 1.0},
    {"fouls", "/stoppages/fouls", 0, 1.0},
    {"distance km", "/distance", 1, 0.001},
};

std::string number_text(double value, int decimals, bool sign) {
  std::string text =
      sign ? fmt::format("{:+.{}f}", value, decimals) : fmt::format("{:.{}f}", value, decimals);
  const bool zero = text.find_first_not_of("+-0.") == std::string::npos;
  return zero && sign ? "0" : text;
}

}  // namespace

std::optional<FrameDifference> first_difference(const MatchRecord& a, const MatchRecord& b) {
  const std::size_t both = std::min(a.frames(), b.frames());
  for (std::size_t frame = 0; frame < both; ++frame) {
    std::vector<std::string> what = differences_at(a, b, frame);
    if (!what.empty()) return FrameDifference{frame, a.time[frame], a.stopped[frame], what};
  }

  if (a.frames() == b.frames()) return std::nullopt;
  const MatchRecord& longer = a.frames() > b.frames() ? a : b;
  return FrameDifference{both, longer.time[both], longer.stopped[both], {"end of the log"}};
}

std::string difference_text(const std::optional<FrameDifference>& difference) {
  constexpr std::size_t kShown = 4;
  if (!difference) return "none";

  const std::vector<std::string>& what = difference->what;
  const std::size_t shown = std::min(kShown, what.size());
  std::string text = fmt::format(
      "cycle {}{} (frame {}): {}", difference->cycle,
      difference->stopped > 0 ? fmt::format("+{}", difference->stopped) : "", difference->frame,
      fmt::join(what.begin(), what.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  if (what.size() > shown) text += fmt::format(" and {} more", what.size() - shown);
  return text;
}

std::vector<LoneEvent> lone_events(const MatchStatistics& a, const MatchStatistics& b) {
  const std::vector<EventKey> first = keys_of(a);
  const std::vector<EventKey> second = keys_of(b);

  std::vector<LoneEvent> events;
  add_missing(first, second, 0, events);
  add_missing(second, first, 1, events);
  std::stable_sort(events.begin(), events.end(),
                   [](const LoneEvent& x, const LoneEvent& y) { return x.cycle < y.cycle; });
  return events;
}

std::vector<std::vector<std::string>> difference_rows(const ComparedMatch& a,
                                                      const ComparedMatch& b) {
  std::vector<std::vector<std::string>> rows = {
      {"", "left A", "left B", "B - A", "right A", "right B", "B - A"}};

  std::array<std::array<analysis::Json, 2>, 2> fields;  // by match and team
  const std::array<const ComparedMatch*, 2> matches = {&a, &b};
  for (std::size_t match = 0; match < 2; ++match) {
    for (std::size_t team = 0; team < 2; ++team) {
      const MatchStatistics& all = *matches[match]->statistics;
      fields[match][team] =
          analysis::team_fields(*matches[match]->summary, all, analysis::sum_team(all, team), team);
    }
  }

  for (const Figure& figure : kFigures) {
    const analysis::Json::json_pointer path(figure.path.text);
    std::vector<std::string> row = {figure.name};
    for (std::size_t team = 0; team < 2; ++team) {
      const auto value = [&](std::size_t match) {
        const analysis::Json& all = fields[match][team];
        return all.contains(path) && all.at(path).is_number()
                   ? all.at(path).get<double>() * figure.scale
                   : 0.0;
      };
      row.push_back(number_text(value(0), figure.decimals, false));
      row.push_back(number_text(value(1), figure.decimals, false));
      row.push_back(number_text(value(1) - value(0), figure.decimals, true));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace cls::viewer
