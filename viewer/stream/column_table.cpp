// The one table of columns.
#include "viewer/stream/column_table.h"

#include <algorithm>
#include <limits>
#include <type_traits>

#include "base/text/enum_names.h"
#include "gamelog/record/record_builder.h"

namespace cls::viewer {
namespace {

using gamelog::kSlots;
using gamelog::MatchRecord;

constexpr auto kCodingNames = base::enum_names<Coding>("c", "d1", "d2", "da", "dv");

constexpr std::int64_t kMaxInt = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t kMaxState = std::numeric_limits<std::uint32_t>::max();
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
    for (std::size_t i = 0; i < count; ++i) {
      to[i] = static_cast<std::int64_t>(At()(record, first + i));
    }
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
      name, Coding::kChanges, kSlots, -kMaxInt - 1, kMaxInt,
      [](auto& r, std::size_t i) -> auto& { return r.players.counters[i][kIndex]; });
}

// clang-format off
#define CLS_AT(expression) [](auto& r, std::size_t i) -> auto& { return r.expression; }

ColumnSpec of_height(ColumnSpec column) {
  column.of_height = true;
  return column;
}

const std::vector<ColumnSpec> kColumns = {
    integers("time", Coding::kSecond, 1, -kMaxInt - 1, kMaxInt, CLS_AT(time[i])),
    integers("stopped", Coding::kSecond, 1, 0, kMaxInt, CLS_AT(stopped[i])),
    integers("mode", Coding::kChanges, 1, 0, soccer::kPlayModeCount - 1, CLS_AT(mode[i])),
    integers("teams", Coding::kChanges, 1, 0, kMaxInt, CLS_AT(team_state[i])),

    reals("ball_x", Coding::kSecond, 1, kLength, kCentimeter, CLS_AT(ball_position[i].x)),
    reals("ball_y", Coding::kSecond, 1, kLength, kCentimeter, CLS_AT(ball_position[i].y)),
    velocities("ball_vx", 1, "ball_x", CLS_AT(ball_velocity[i].x)),
    velocities("ball_vy", 1, "ball_y", CLS_AT(ball_velocity[i].y)),
    of_height(reals("ball_z", Coding::kSecond, 1, kLength, kCentimeter, CLS_AT(ball_height[i]))),

    integers("state", Coding::kChanges, kSlots, 0, kMaxState, CLS_AT(players.state[i])),
    integers("type", Coding::kChanges, kSlots, -gamelog::kMaxPlayerType, gamelog::kMaxPlayerType, CLS_AT(players.type[i])),

    reals("x", Coding::kSecond, kSlots, kLength, kCentimeter, CLS_AT(players.position[i].x)),
    reals("y", Coding::kSecond, kSlots, kLength, kCentimeter, CLS_AT(players.position[i].y)),
    velocities("vx", kSlots, "x", CLS_AT(players.velocity[i].x)),
    velocities("vy", kSlots, "y", CLS_AT(players.velocity[i].y)),

    reals("body", Coding::kAngle, kSlots, kDegree, 1, CLS_AT(players.body[i])),
    reals("neck", Coding::kAngle, kSlots, kDegree, 1, CLS_AT(players.neck[i])),
    points("point_x", CLS_AT(players.pointing_at[i].x)),
    points("point_y", CLS_AT(players.pointing_at[i].y)),

    reals("view_width", Coding::kChanges, kSlots, kDegree, 1, CLS_AT(players.view_width[i])),
    integers("high_quality", Coding::kChanges, kSlots, 0, 1, CLS_AT(players.high_quality[i])),
    reals("focus_distance", Coding::kChanges, kSlots, kLength, 10, CLS_AT(players.focus[i].x)),
    reals("focus_direction", Coding::kChanges, kSlots, kLength, 1, CLS_AT(players.focus[i].y)),

    reals("stamina", Coding::kFirst, kSlots, kStamina, 1, CLS_AT(players.stamina[i])),
    reals("effort", Coding::kChanges, kSlots, kFactor, 100, CLS_AT(players.effort[i])),
    reals("recovery", Coding::kChanges, kSlots, kFactor, 100, CLS_AT(players.recovery[i])),
    reals("capacity", Coding::kFirst, kSlots, kStamina, 1, CLS_AT(players.capacity[i])),
    integers("attention", Coding::kChanges, kSlots, -1, kSlots - 1, CLS_AT(players.attention[i])),

    counter<0>("count_kick"),
    counter<1>("count_dash"),
    counter<2>("count_turn"),
    counter<3>("count_catch"),
    counter<4>("count_move"),
    counter<5>("count_turn_neck"),
    counter<6>("count_change_view"),
    counter<7>("count_say"),
    counter<8>("count_tackle"),
    counter<9>("count_pointto"),
    counter<10>("count_attentionto"),
    counter<11>("count_change_focus"),
};

#undef CLS_AT
// clang-format on

}  // namespace

std::string_view name(Coding coding) { return kCodingNames.name(coding); }

std::optional<Coding> parse_coding(std::string_view text) { return kCodingNames.parse(text); }

const std::vector<ColumnSpec>& column_table() { return kColumns; }

const ColumnSpec* find_column(std::string_view name) {
  const auto found = std::ranges::find(kColumns, name, &ColumnSpec::name);
  return found == kColumns.end() ? nullptr : &*found;
}

}  // namespace cls::viewer
