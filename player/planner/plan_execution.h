// Execution of the first action of a plan.
#pragma once

#include <cstdint>
#include <optional>

#include "player/planner/action_context.h"
#include "player/planner/plan.h"
#include "player/planner/planner.h"

namespace cls::player {

/// Plans with default options and evaluation, and executes the best action.
bool execute_default_plan(ActionContext& context);

/// Executes the first action on the path to `node` (docs/spec/proxy-behavior.md 5.6) and queues a
/// neck plan. A dribble sets an intention; a pass is announced to its receiver. False without
/// effect if the ball is not kickable, and for dribbles and holds in set plays.
bool execute_plan(ActionContext& context, const Plan& plan, int node);

/// Executes one action of the agent by the same rules.
bool execute_action(ActionContext& context, const PlanAction& action);

/// Executes the plan, or holds the ball where the plan cannot be executed.
bool execute_plan_or_hold(ActionContext& context, const Plan& plan, int node);

/// Best outlet, or a clearance. False if the ball is not kickable.
bool kick_outlet(ActionContext& context);

/// Where the agent can shoot at their goal without a plan.
struct Gap {
  double degrees = 0.0;  ///< free angle around the target
  Vec2 target;
};
/// The widest gap between the posts as seen from the ball; of 0 degrees if there is none.
Gap widest_gap(const WorldModel& world);
/// The same; empty if there is none, or the goal is too far.
std::optional<Gap> gap_in_range(const WorldModel& world);

// The ways of holding the ball, which hold_kind() chooses among. False without effect if a way is
// not possible.

enum class HoldKind : std::uint8_t { kShoot, kLayOff, kKeep };
/// `ball_since`: ActionMemory::ball_since.
HoldKind hold_kind(const WorldModel& world, int ball_since);

/// Shoots into the widest gap.
bool shoot_into_gap(ActionContext& context);
/// The teammate with most free space along the way of a hard pass; null: none has enough.
const PlayerState* lay_off_receiver(const WorldModel& world);
/// Passes hard to lay_off_receiver().
bool lay_off(ActionContext& context);
/// Keeps the ball away from opponents; clears it in front of the own goal.
bool keep_ball(ActionContext& context);

/// True with the ball near the own goal and an opponent near.
bool is_ball_in_danger(const WorldModel& world);
/// Kicks to the best outlet, or clears, with the ball near the own goal and an opponent near: a
/// lost pass would be a shot at us.
bool kick_out_of_danger(ActionContext& context);

/// The plan of this decision, made at the first call. The agent has the ball.
const Plan& plan_of_decision(ActionContext& context, const PlannerOptions& options,
                             const NodeValue& value = default_value);

}  // namespace cls::player
