// Action sets "low", "low_all" and "low_flat": the commands of the soccer server.
#include <algorithm>
#include <array>

#include "training/actions/action_set.h"
#include "training/actions/conditions.h"

namespace cls::training {
namespace {

const Column kPower = {"power", "1", 0, 100};
const Column kDirection = {"direction", "deg", -180, 180};

PlayerCommand dash(const PointOfView&, const float* v) { return soccer::Dash{v[0], v[1]}; }
PlayerCommand turn(const PointOfView&, const float* v) { return soccer::Turn{v[0]}; }
PlayerCommand kick(const PointOfView&, const float* v) { return soccer::Kick{v[0], v[1]}; }
PlayerCommand tackle(const PointOfView&, const float* v) { return soccer::Tackle{v[0], false}; }

std::vector<Action> common() {
  return {{"dash", {kPower, kDirection}, dash},
          {"turn", {kDirection}, turn},
          {"kick", {kPower, kDirection}, kick, has_ball}};
}

// Layout of "low_flat": scores of the four kinds, then their parameters.
PlayerCommand choose(const PointOfView&, const float* values) {
  const auto scores = std::array<float, 4>{values[0], values[1], values[2], values[3]};
  const auto best = std::max_element(scores.begin(), scores.end()) - scores.begin();
  const auto power = [&](int i) { return (values[i] + 1.0F) * 50.0F; };
  const auto angle = [&](int i) { return values[i] * 180.0F; };

  switch (best) {
    case 0:
      return soccer::Dash{power(4), angle(5)};
    case 1:
      return soccer::Turn{angle(6)};
    case 2:
      return soccer::Tackle{angle(7), false};
    default:
      return soccer::Kick{power(8), angle(9)};
  }
}

}  // namespace

const ActionSet& low_actions() {
  static const ActionSet set = {"low",    1,  "dash, turn and kick with their own parameters",
                                common(), {}, nullptr};
  return set;
}

const ActionSet& low_all_actions() {
  static const ActionSet set = [] {
    ActionSet all = {"low_all", 1, "low, tackle and catch", common(), {}, nullptr};
    all.actions.push_back({"tackle", {kDirection}, tackle, tackle_reaches});
    all.actions.push_back({"catch", {}, catch_now, catch_reaches});
    return all;
  }();
  return set;
}

const ActionSet& low_flat_actions() {
  static const ActionSet set = {"low_flat",
                                1,
                                "scores of dash, turn, tackle and kick and their parameters in "
                                "-1..1; the highest score acts",
                                {},
                                {{"dash_score", "1"},
                                 {"turn_score", "1"},
                                 {"tackle_score", "1"},
                                 {"kick_score", "1"},
                                 {"dash_power", "-1: 0, 1: 100"},
                                 {"dash_direction", "180 deg"},
                                 {"turn_direction", "180 deg"},
                                 {"tackle_direction", "180 deg"},
                                 {"kick_power", "-1: 0, 1: 100"},
                                 {"kick_direction", "180 deg"}},
                                choose};
  return set;
}

}  // namespace cls::training
