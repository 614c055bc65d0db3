// Action set "low_discrete": 81 commands without parameters.
#include <array>
#include <string>

#include "training/actions/family.h"
#include "training/actions/shared_actions.h"

namespace cls::training {
namespace {

struct Dashes {
  static constexpr std::array<int, 8> kDirections = {-180, -135, -90, -45, 0, 45, 90, 135};
  static constexpr std::array<int, 2> kPowers = {50, 100};
  static constexpr std::size_t kCount = kDirections.size() * kPowers.size();

  static int power(std::size_t i) { return kPowers[i % 2]; }
  static int direction(std::size_t i) { return kDirections[i / 2]; }
  static std::string name(std::size_t i) {
    return "dash_" + std::to_string(power(i)) + "_" + std::to_string(direction(i));
  }
  static PlayerCommand command(const PointOfView&, std::size_t i) {
    return soccer::Dash{static_cast<double>(power(i)), static_cast<double>(direction(i))};
  }
};

struct Turns {
  static constexpr std::array<int, 8> kMoments = {-120, -60, -30, -10, 10, 30, 60, 120};
  static constexpr std::size_t kCount = kMoments.size();

  static std::string name(std::size_t i) { return "turn_" + std::to_string(kMoments[i]); }
  static PlayerCommand command(const PointOfView&, std::size_t i) {
    return soccer::Turn{static_cast<double>(kMoments[i])};
  }
};

struct Kicks {
  static constexpr std::array<int, 3> kPowers = {20, 50, 100};
  static constexpr std::size_t kCount = 48;  // sixteen directions

  static int power(std::size_t i) { return kPowers[i % 3]; }
  static std::string name(std::size_t i) {
    return "kick_" + std::to_string(power(i)) + "_" + std::to_string(i / 3);
  }
  static PlayerCommand command(const PointOfView&, std::size_t i) {
    return soccer::Kick{static_cast<double>(power(i)), 22.5 * static_cast<double>(i / 3) - 180.0};
  }
  static constexpr Condition kLegal = has_ball;
};

struct Tackles {
  static constexpr std::array<int, 8> kDirections = {-180, -135, -90, -45, 0, 45, 90, 135};
  static constexpr std::size_t kCount = kDirections.size();

  static std::string name(std::size_t i) { return "tackle_" + std::to_string(kDirections[i]); }
  static PlayerCommand command(const PointOfView&, std::size_t i) {
    return soccer::Tackle{static_cast<double>(kDirections[i]), false};
  }
  static constexpr Condition kLegal = tackle_reaches;
};

}  // namespace

const ActionSet& low_discrete_actions() {
  static const ActionSet set = [] {
    ActionSet all = {.name = "low_discrete",
                     .summary =
                         "noop, 16 dashes, 8 turns, 48 kicks and 8 tackles; kick_POWER_I has "
                         "direction 22.5 I - 180 degrees",
                     .actions = {{"noop", {}, nothing}}};
    append_family<Dashes>(all.actions);
    append_family<Turns>(all.actions);
    append_family<Kicks>(all.actions);
    append_family<Tackles>(all.actions);
    return all;
  }();
  return set;
}

}  // namespace cls::training
