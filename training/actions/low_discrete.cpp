// Action set "low_discrete": 81 commands without parameters.
#include <array>
#include <deque>
#include <string>
#include <utility>

#include "training/actions/action_set.h"

namespace cls::training {
namespace {

constexpr std::array<int, 8> kDashDirections = {-180, -135, -90, -45, 0, 45, 90, 135};
constexpr std::array<int, 2> kDashPowers = {50, 100};
constexpr std::array<int, 8> kTurns = {-120, -60, -30, -10, 10, 30, 60, 120};
constexpr std::array<int, 3> kKickPowers = {20, 50, 100};
constexpr std::array<int, 8> kTackles = {-180, -135, -90, -45, 0, 45, 90, 135};

template <std::size_t kIndex>
PlayerCommand dash(const PointOfView&, const float*) {
  return soccer::Dash{static_cast<double>(kDashPowers[kIndex % 2]),
                      static_cast<double>(kDashDirections[kIndex / 2])};
}
template <std::size_t kIndex>
PlayerCommand turn(const PointOfView&, const float*) {
  return soccer::Turn{static_cast<double>(kTurns[kIndex])};
}
template <std::size_t kIndex>
PlayerCommand kick(const PointOfView&, const float*) {
  return soccer::Kick{static_cast<double>(kKickPowers[kIndex % 3]),
                      22.5 * static_cast<double>(kIndex / 3) - 180.0};
}
template <std::size_t kIndex>
PlayerCommand tackle(const PointOfView&, const float*) {
  return soccer::Tackle{static_cast<double>(kTackles[kIndex]), false};
}

bool can_kick_now(const PointOfView& view) { return can_kick(view.scene, view.self); }
bool can_tackle_now(const PointOfView& view) { return tackle_chance(view.scene, view.self) > 0.0; }

/// Names that live as long as the program.
std::string_view stored(std::string name) {
  static std::deque<std::string> names;
  return names.emplace_back(std::move(name));
}

template <std::size_t... kIndices>
void add_dashes(std::vector<Action>& out, std::index_sequence<kIndices...>) {
  (out.push_back({stored("dash_" + std::to_string(kDashPowers[kIndices % 2]) + "_" +
                         std::to_string(kDashDirections[kIndices / 2])),
                  {},
                  dash<kIndices>}),
   ...);
}
template <std::size_t... kIndices>
void add_turns(std::vector<Action>& out, std::index_sequence<kIndices...>) {
  (out.push_back({stored("turn_" + std::to_string(kTurns[kIndices])), {}, turn<kIndices>}), ...);
}
template <std::size_t... kIndices>
void add_kicks(std::vector<Action>& out, std::index_sequence<kIndices...>) {
  (out.push_back({stored("kick_" + std::to_string(kKickPowers[kIndices % 3]) + "_" +
                         std::to_string(static_cast<int>(kIndices / 3))),
                  {},
                  kick<kIndices>,
                  can_kick_now}),
   ...);
}
template <std::size_t... kIndices>
void add_tackles(std::vector<Action>& out, std::index_sequence<kIndices...>) {
  (out.push_back({stored("tackle_" + std::to_string(kTackles[kIndices])),
                  {},
                  tackle<kIndices>,
                  can_tackle_now}),
   ...);
}

PlayerCommand nothing(const PointOfView&, const float*) { return stand(); }

}  // namespace

const ActionSet& low_discrete_actions() {
  static const ActionSet set = [] {
    ActionSet all = {"low_discrete",
                     1,
                     "noop, 16 dashes, 8 turns, 48 kicks and 8 tackles; kick_POWER_I has "
                     "direction 22.5 I - 180 degrees",
                     {},
                     {},
                     nullptr};
    all.actions.push_back({"noop", {}, nothing});
    add_dashes(all.actions, std::make_index_sequence<16>());
    add_turns(all.actions, std::make_index_sequence<8>());
    add_kicks(all.actions, std::make_index_sequence<48>());
    add_tackles(all.actions, std::make_index_sequence<8>());
    return all;
  }();
  return set;
}

}  // namespace cls::training
