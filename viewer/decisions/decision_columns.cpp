// One row per column.
#include "viewer/decisions/decision_columns.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace cls::viewer {
namespace {

constexpr std::size_t kSlots = soccer::kPlayersOnPitch;
// Players in the distance are seen with errors of some decimeters.
constexpr int kCentimeters = 100;
constexpr int kDecimeters = 10;

/// The nearest value that the place can hold: files may contain anything.
template <typename T>
T nearest(double value) {
  if constexpr (std::is_enum_v<T>) {
    return static_cast<T>(nearest<std::underlying_type_t<T>>(value));
  } else if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(value);
  } else {
    constexpr auto kMin = static_cast<double>(std::numeric_limits<T>::min());
    constexpr auto kMax = static_cast<double>(std::numeric_limits<T>::max());
    return static_cast<T>(std::clamp(value, kMin, kMax));
  }
}

// `At` is a lambda without captures: at(sample, slot) refers to the value.
template <typename At>
DecisionColumnSpec column(std::string_view name, Coding coding, std::size_t series, int scale, At) {
  DecisionColumnSpec spec{name, coding, series, scale, nullptr, nullptr};
  spec.load = [](const SlottedSample& from, std::size_t slot) {
    return static_cast<double>(At()(from, slot));
  };
  spec.store = [](SlottedSample& to, std::size_t slot, double value) {
    auto& place = At()(to, slot);
    place = nearest<std::remove_reference_t<decltype(place)>>(value);
  };
  return spec;
}

}  // namespace

// clang-format off
#define CLS_AT(expression) [](auto& r, [[maybe_unused]] std::size_t i) -> auto& { return r.expression; }

const std::vector<DecisionColumnSpec>& decision_columns() {
  constexpr Coding kD1 = Coding::kFirst;
  constexpr Coding kChange = Coding::kChanges;
  static const std::vector<DecisionColumnSpec> table = {
      column("cycle", kD1, 1, 1, CLS_AT(sample.cycle)),
      column("stopped", kD1, 1, 1, CLS_AT(sample.stopped)),
      column("maker", kChange, 1, 1, CLS_AT(sample.maker)),
      column("call", kChange, 1, 1, CLS_AT(sample.call)),

      column("self_x", Coding::kSecond, 1, kCentimeters, CLS_AT(sample.self.x)),
      column("self_y", Coding::kSecond, 1, kCentimeters, CLS_AT(sample.self.y)),
      column("self_body", Coding::kAngle, 1, 1, CLS_AT(sample.self_body)),
      column("self_neck", Coding::kAngle, 1, 1, CLS_AT(sample.self_neck)),
      column("self_age", kD1, 1, 1, CLS_AT(sample.self_age)),

      column("ball_x", Coding::kSecond, 1, kCentimeters, CLS_AT(sample.ball.x)),
      column("ball_y", Coding::kSecond, 1, kCentimeters, CLS_AT(sample.ball.y)),
      column("ball_vx", kD1, 1, kCentimeters, CLS_AT(sample.ball_velocity.x)),
      column("ball_vy", kD1, 1, kCentimeters, CLS_AT(sample.ball_velocity.y)),
      column("ball_age", kD1, 1, 1, CLS_AT(sample.ball_age)),
      column("ball_velocity_age", kD1, 1, 1, CLS_AT(sample.ball_velocity_age)),

      column("own_reach", kD1, 1, 1, CLS_AT(sample.own_reach)),
      column("teammate_reach", kD1, 1, 1, CLS_AT(sample.teammate_reach)),
      column("opponent_reach", kD1, 1, 1, CLS_AT(sample.opponent_reach)),

      column("age", kD1, kSlots, 1, CLS_AT(sample.players[i].age)),
      column("x", kD1, kSlots, kDecimeters, CLS_AT(sample.players[i].position.x)),
      column("y", kD1, kSlots, kDecimeters, CLS_AT(sample.players[i].position.y)),
      column("other_id", kChange, kSlots, 1, CLS_AT(unnumbered[i].id)),
      column("other_side", kChange, kSlots, 1, CLS_AT(unnumbered[i].side)),
      column("other_age", kChange, kSlots, 1, CLS_AT(unnumbered[i].estimate.age)),
      column("other_x", kChange, kSlots, kDecimeters, CLS_AT(unnumbered[i].estimate.position.x)),
      column("other_y", kChange, kSlots, kDecimeters, CLS_AT(unnumbered[i].estimate.position.y)),
  };

  return table;
}

#undef CLS_AT
// clang-format on

}  // namespace cls::viewer
