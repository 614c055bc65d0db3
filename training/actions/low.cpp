// Action sets "low", "low_all" and "low_flat": the commands of the soccer server.
#include <algorithm>

#include "training/actions/shared_actions.h"

namespace cls::training {
namespace {

std::vector<Action> common() {
  return {{"dash", {kPower, kDirection}, dash},
          {"turn", {kDirection}, turn},
          {"kick", {kPower, kDirection}, kick, has_ball}};
}

// Layout of "low_flat": scores of the four kinds, then their parameters.
PlayerCommand choose(const PointOfView&, const float* values) {
  const auto best = std::max_element(values, values + 4) - values;
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
  static const ActionSet set = {.name = "low",
                                .summary = "dash, turn and kick with their own parameters",
                                .actions = common()};
  return set;
}

const ActionSet& low_all_actions() {
  static const ActionSet set = [] {
    ActionSet all = {.name = "low_all", .summary = "low, tackle and catch", .actions = common()};
    all.actions.push_back({"tackle", {kDirection}, tackle, tackle_reaches});
    all.actions.push_back({"catch", {}, catch_now, catch_reaches});
    return all;
  }();
  return set;
}

const ActionSet& low_flat_actions() {
  static const ActionSet set = [] {
    ActionSet flat = {.name = "low_flat",
                      .summary =
                          "scores of dash, turn, tackle and kick and their parameters in "
                          "-1..1; the highest score acts",
                      .choose = choose};
    append(flat.box, "", {"dash_score", "turn_score", "tackle_score", "kick_score"});
    append(flat.box, "", {"dash_power"}, "-1: 0, 1: 100");
    append(flat.box, "", {"dash_direction", "turn_direction", "tackle_direction"}, "180 deg");
    append(flat.box, "", {"kick_power"}, "-1: 0, 1: 100");
    append(flat.box, "", {"kick_direction"}, "180 deg");
    return flat;
  }();
  return set;
}

}  // namespace cls::training
