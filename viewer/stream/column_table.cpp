// The one table of columns.
#include "viewer/stream/column_table.h"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

#include "gamelog/record/record_builder.h"

namespace cls::viewer {
namespace {

using gamelog::kSlots;
using gamelog::MatchRecord;

constexpr std::array<std::string_view, 5> kCodingNames = {"c", "d1", "d2", "da", "dv"};

constexpr int kLength = 10000;  // units per meter, the precision of logs
constexpr int kDegree = 1000;
constexpr int kStamina = 100;
constexpr int kFactor = 1000000;
constexpr int kCentimeter = 100;

// `At` is a lambda without captures: at(record, entry) refers to the value.
template <typename At>
ColumnSpec integers(std::string_view name, Coding coding, std::size_t series, std::int64_t min,
                    std::int64_t max, At) {
  ColumnSpec column{name, coding, series};
  column.min = min;
  column.max = max;

  column.load_integers = [](const MatchRecord& record, std::size_t first, std::size_t count,
                            std::int64_t* to) {
    for (std::size_t i = 0; i < count; ++i)
      to[i] = static_cast<std::int64_t>(At()(record, first + i));
  };
  column.store_integers = [](MatchRecord& record, std::size_t first, std::size_t count,
                             const std::int64_t* from) {
    for (std::size_t i = 0; i < count; ++i) {
      auto& value = At()(record, first + i);
      value = static_cast<std::remove_reference_t<decltype(value)>>(from[i]);
    }
  };
  return column;
}

template <typename At>
ColumnSpec reals(std::string_view name, Coding coding, std::size_t series, int scale,
                 int compact_scale, At) {
  ColumnSpec column{name, coding, series, scale, compact_scale};
  column.load_reals = [](const MatchRecord& record, std::size_t first, std::size_t count,
                         float* to) {
    for (std::size_t i = 0; i < count; ++i) to[i] = At()(record, first + i);
  };
  column.store_reals = [](MatchRecord& record, std::size_t first, std::size_t count,
                          const float* from) {
    for (std::size_t i = 0; i < count; ++i) At()(record, first + i) = from[i];
  };
  return column;
}

template <typename At>
ColumnSpec velocities(std::string_view name, std::size_t series, std::string_view of, At at) {
  ColumnSpec column = reals(name, Coding::kVelocity, series, kLength, 0, at);
  column.of = of;
  return column;
}

template <typename At>
ColumnSpec points(std::string_view name, At at) {
  ColumnSpec column = reals(name, Coding::kChanges, kSlots, kLength, kCentimeter, at);
  column.optional = true;
  return column;
}

template <std::size_t kIndex>
ColumnSpec counter(std::string_view name) {
  return integers(
      name, Coding::kChanges, kSlots, std::numeric_limits<std::int32_t>::min(),
      std::numeric_limits<std::int32_t>::max(),
      [](auto& r, std::size_t i) -> auto& { return r.players.counters[i][kIndex]; });
}

// clang-format off
#define CLS_AT(expression) [](auto& r, std::size_t i) -> auto& { return r.expression; }

void add_match_columns(std::vector<ColumnSpec>& table) {
  constexpr std::int64_t kMaxInt = std::numeric_limits<std::int32_t>::max();
  table.push_back(integers("time", Coding::kSecond, 1, -kMaxInt - 1, kMaxInt, CLS_AT(time[i])));
  table.push_back(integers("stopped", Coding::kSecond, 1, 0, kMaxInt, CLS_AT(stopped[i])));
  table.push_back(integers("mode", Coding::kChanges, 1, 0, soccer::kPlayModeCount - 1, CLS_AT(mode[i])));
  table.push_back(integers("teams", Coding::kChanges, 1, 0, kMaxInt, CLS_AT(team_state[i])));

  table.push_back(reals("ball_x", Coding::kSecond, 1, kLength, kCentimeter, CLS_AT(ball_position[i].x)));
  table.push_back(reals("ball_y", Coding::kSecond, 1, kLength, kCentimeter, CLS_AT(ball_position[i].y)));
  table.push_back(velocities("ball_vx", 1, "ball_x", CLS_AT(ball_velocity[i].x)));
  table.push_back(velocities("ball_vy", 1, "ball_y", CLS_AT(ball_velocity[i].y)));
  table.push_back(reals("ball_z", Coding::kSecond, 1, kLength, kCentimeter, CLS_AT(ball_height[i])));
  table.back().of_height = true;
}

void add_player_columns(std::vector<ColumnSpec>& table) {
  constexpr std::int64_t kMaxState = std::numeric_limits<std::uint32_t>::max();
  table.push_back(integers("state", Coding::kChanges, kSlots, 0, kMaxState, CLS_AT(players.state[i])));
  table.push_back(integers("type", Coding::kChanges, kSlots, -gamelog::kMaxPlayerType, gamelog::kMaxPlayerType,
                           CLS_AT(players.type[i])));

  table.push_back(reals("x", Coding::kSecond, kSlots, kLength, kCentimeter, CLS_AT(players.position[i].x)));
  table.push_back(reals("y", Coding::kSecond, kSlots, kLength, kCentimeter, CLS_AT(players.position[i].y)));
  table.push_back(velocities("vx", kSlots, "x", CLS_AT(players.velocity[i].x)));
  table.push_back(velocities("vy", kSlots, "y", CLS_AT(players.velocity[i].y)));

  table.push_back(reals("body", Coding::kAngle, kSlots, kDegree, 1, CLS_AT(players.body[i])));
  table.push_back(reals("neck", Coding::kAngle, kSlots, kDegree, 1, CLS_AT(players.neck[i])));
  table.push_back(points("point_x", CLS_AT(players.pointing_at[i].x)));
  table.push_back(points("point_y", CLS_AT(players.pointing_at[i].y)));

  table.push_back(reals("view_width", Coding::kChanges, kSlots, kDegree, 1, CLS_AT(players.view_width[i])));
  table.push_back(integers("high_quality", Coding::kChanges, kSlots, 0, 1, CLS_AT(players.high_quality[i])));
  table.push_back(reals("focus_distance", Coding::kChanges, kSlots, kLength, 10, CLS_AT(players.focus[i].x)));
  table.push_back(reals("focus_direction", Coding::kChanges, kSlots, kLength, 1, CLS_AT(players.focus[i].y)));

  table.push_back(reals("stamina", Coding::kFirst, kSlots, kStamina, 1, CLS_AT(players.stamina[i])));
  table.push_back(reals("effort", Coding::kChanges, kSlots, kFactor, 100, CLS_AT(players.effort[i])));
  table.push_back(reals("recovery", Coding::kChanges, kSlots, kFactor, 100, CLS_AT(players.recovery[i])));
  table.push_back(reals("capacity", Coding::kFirst, kSlots, kStamina, 1, CLS_AT(players.capacity[i])));
  table.push_back(integers("attention", Coding::kChanges, kSlots, -1, kSlots - 1, CLS_AT(players.attention[i])));
}

#undef CLS_AT
// clang-format on

void add_counters(std::vector<ColumnSpec>& table) {
  table.push_back(counter<0>("count_kick"));
  table.push_back(counter<1>("count_dash"));
  table.push_back(counter<2>("count_turn"));
  table.push_back(counter<3>("count_catch"));
  table.push_back(counter<4>("count_move"));
  table.push_back(counter<5>("count_turn_neck"));
  table.push_back(counter<6>("count_change_view"));
  table.push_back(counter<7>("count_say"));
  table.push_back(counter<8>("count_tackle"));
  table.push_back(counter<9>("count_pointto"));
  table.push_back(counter<10>("count_attentionto"));
  table.push_back(counter<11>("count_change_focus"));
}

}  // namespace

std::string_view name(Coding coding) { return kCodingNames[static_cast<std::size_t>(coding)]; }

bool parse_coding(std::string_view text, Coding& coding) {
  const auto found = std::find(kCodingNames.begin(), kCodingNames.end(), text);
  if (found == kCodingNames.end()) return false;
  coding = static_cast<Coding>(found - kCodingNames.begin());
  return true;
}

const std::vector<ColumnSpec>& column_table() {
  static const std::vector<ColumnSpec> table = [] {
    std::vector<ColumnSpec> columns;
    add_match_columns(columns);
    add_player_columns(columns);
    add_counters(columns);
    return columns;
  }();
  return table;
}

const ColumnSpec* find_column(std::string_view name) {
  const auto& table = column_table();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [name](const ColumnSpec& column) { return column.name == name; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace cls::viewer
