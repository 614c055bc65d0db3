// Two-leg dashes: each leg pushes with its own power and direction, which also turns the body.
#pragma once

#include <optional>

#include "player/world/world_model.h"
#include "soccer/commands/player_command.h"

namespace cls::player {

/// The effect of a dash in the next step, without noise (docs/spec/simulation-model.md 4.3).
struct DashEffect {
  Vec2 acceleration;  ///< pitch axes
  double turn = 0.0;  ///< of the body, degrees; positive: clockwise as printed angles
  double cost = 0.0;  ///< stamina
};

/// Effect of a dash of the agent with its current stamina and effort, and the body at `body`.
DashEffect leg_dash_effect(const WorldModel& world, AngleDeg body, const soccer::LegDash& legs);

/// A two-leg dash that turns the body by a given angle.
struct LegTurn {
  soccer::LegDash legs;
  Vec2 acceleration;        ///< pitch axes
  double cost = 0.0;        ///< stamina
  double progress = 0.0;    ///< acceleration in the direction to which the body turns
  double efficiency = 0.0;  ///< progress as a share of what a plain dash for the same stamina gives
};

/// The dash that turns the body by `angle` degrees in one cycle, at any speed of the agent, and
/// meanwhile accelerates most in that direction, for at most `power` stamina. None if the legs
/// cannot turn it so far (97 degrees with full effort and the default parameters).
std::optional<LegTurn> leg_turn(const WorldModel& world, double angle, double power);

/// leg_turn() where it is better than turning first and dashing then: agents use two-leg dashes
/// (WorldModel::leg_dashes), and the turn either gains speed or is more than a turn command can do
/// at this speed. `hurry` accepts dashes that waste stamina.
std::optional<LegTurn> useful_leg_turn(const WorldModel& world, double angle, double power,
                                       bool hurry);

}  // namespace cls::player
