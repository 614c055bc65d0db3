// Execution of the first action of a plan.
#pragma once

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

/// Executes the plan, or holds the ball where the plan cannot be executed.
bool execute_plan_or_hold(ActionContext& context, const Plan& plan, int node);

/// Best outlet, or a clearance. False if the ball is not kickable.
bool kick_outlet(ActionContext& context);

/// Kicks to the best outlet, or clears, with the ball near the own goal and an opponent near: a
/// lost pass would be a shot at us.
bool kick_out_of_danger(ActionContext& context);

/// The plan of this decision, made at the first call. The agent has the ball.
const Plan& plan_of_decision(ActionContext& context, const PlannerOptions& options,
                             const NodeValue& value = default_value);

}  // namespace cls::player
