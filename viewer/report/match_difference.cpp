// Compares frames, events and figures.
#include "viewer/report/match_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <tuple>

#include "analysis/statistics/event_list.h"
#include "analysis/statistics/field_table.h"
#include "soccer/side.h"

namespace cls::viewer {
namespace {

using analysis::EventKind;
using analysis::MatchStatistics;
using gamelog::Column;
using gamelog::MatchRecord;
using gamelog::PlayerColumns;

// Logs have NaN where an arm does not point, so equal bits are equal values.
template <typename T>
bool differs(const Column<T>& a, const Column<T>& b, std::size_t at) {
  return std::memcmp(&a[at], &b[at], sizeof(T)) != 0;
}

std::string player_text(std::size_t slot) {
  return fmt::format("{} {}", analysis::side_text(static_cast<int>(slot)), analysis::unum_of(slot));
}

void add_players(const MatchRecord& a, const MatchRecord& b, std::size_t frame,
                 std::vector<std::string>& what) {
  const PlayerColumns& p = a.players;
  const PlayerColumns& q = b.players;
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const std::size_t at = analysis::entry_of(frame, slot);
    const auto add = [&](bool different, const char* name) {
      if (different) what.push_back(fmt::format("{} {}", player_text(slot), name));
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
    return gamelog::teams_at(record, frame)[team].score;
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
    if (event.kind != EventKind::kGoal && event.kind != EventKind::kShot &&
        event.kind != EventKind::kFoul) {
      continue;
    }
    keys.emplace_back(event.cycle, name(event.kind), event.slot, event.result);
  }
  std::ranges::sort(keys);
  return keys;
}

// "foul_charge_l", a play mode, is "foul charge": the player says which side.
std::string words_of(std::string name) {
  if (name.ends_with("_l") || name.ends_with("_r")) name.resize(name.size() - 2);
  std::ranges::replace(name, '_', ' ');
  return name;
}

void add_missing(const std::vector<EventKey>& from, const std::vector<EventKey>& in,
                 std::size_t match, std::vector<LoneEvent>& events) {
  std::vector<EventKey> lone;
  std::ranges::set_difference(from, in, std::back_inserter(lone));
  for (const auto& [cycle, kind, slot, result] : lone) {
    std::string text = kind;
    if (slot >= 0) text += ", " + player_text(base::index(slot));
    if (!result.empty() && result != kind) text += ": " + words_of(result);
    events.push_back({match, cycle, std::move(text)});
  }
}

/// A statistic of a team.
struct Figure {
  const char* name;
  analysis::TeamStatistic statistic;
  int decimals;
  double scale = 1.0;
};

constexpr Figure kFigures[] = {
    {"goals", "/score", 0},
    {"shots", "/shots/total", 0},
    {"shots on target", "/shots/on_target", 0},
    {"expected goals", "/shots/expected_goals", 2},
    {"possession %", "/possession/last_touch", 1, 100.0},
    {"touches", "/touches", 0},
    {"passes completed", "/passes/completed", 0},
    {"passes attempted", "/passes/attempted", 0},
    {"dribbles", "/dribbles", 0},
    {"box entries", "/territory/box_entries", 0},
    {"pitch control %", "/territory/pitch_control", 1, 100.0},
    {"successful tackles", "/tackles/succeeded", 0},
    {"interceptions", "/interceptions", 0},
    {"fouls", "/stoppages/fouls", 0},
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
  std::ranges::stable_sort(events, {}, &LoneEvent::cycle);
  return events;
}

std::vector<std::vector<std::string>> difference_rows(const ComparedMatch& a,
                                                      const ComparedMatch& b) {
  std::vector<std::vector<std::string>> rows = {
      {"", "left A", "left B", "B - A", "right A", "right B", "B - A"}};
  for (const Figure& figure : kFigures) rows.push_back({figure.name});

  for (std::size_t team = 0; team < 2; ++team) {
    const analysis::TeamView first = {*a.summary, *a.statistics, team};
    const analysis::TeamView second = {*b.summary, *b.statistics, team};
    for (std::size_t i = 0; i < std::size(kFigures); ++i) {
      const Figure& figure = kFigures[i];
      const auto value_in = [&](const analysis::TeamView& view) {
        return figure.statistic.row->value(view)->get<double>() * figure.scale;
      };
      const auto add = [&](double value, bool sign) {
        rows[i + 1].push_back(number_text(value, figure.decimals, sign));
      };
      add(value_in(first), false);
      add(value_in(second), false);
      add(value_in(second) - value_in(first), true);
    }
  }
  return rows;
}

}  // namespace cls::viewer
