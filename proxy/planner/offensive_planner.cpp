// Plans, chooses and executes an action.
#include "proxy/planner/offensive_planner.h"

#include "proto/playmaker.pb.h"
#include "proxy/ball_skills/hold_ball.h"
#include "proxy/planner/field.h"
#include "proxy/planner/plan_execution.h"
#include "proxy/planner/planner_messages.h"
#include "proxy/planner/search.h"

namespace cls::proxy {
namespace {

/// The planner action that defines the tree of this decision: the first one in the reply.
const protos::HeliosOffensivePlanner& tree_action(const protos::HeliosOffensivePlanner& action,
                                                  const ActionContext& c) {
  if (c.reply == nullptr) return action;
  for (const protos::PlayerAction& each : c.reply->actions()) {
    if (each.has_helios_offensive_planner()) return each.helios_offensive_planner();
  }
  return action;
}

bool hold(ActionContext& c) {
  c.neck.kind = NeckPlan::Kind::kScan;
  return hold_ball(c.world, c.slots, false, {});
}

}  // namespace

bool run_offensive_planner(const protos::HeliosOffensivePlanner& action, ActionContext& c) {
  if (!c.world.self.kickable || c.world.self.frozen()) return false;
  const protos::HeliosOffensivePlanner& tree_options = tree_action(action, c);
  if (c.choice.plan.empty()) {
    const int held = c.memory.ball_since < 0 ? 0 : c.world.game.time.cycle - c.memory.ball_since;
    const PlannerField field(c.world, held);
    c.choice.plan = make_plan(field, planner_options(tree_options),
                              tree_options.has_evaluation() ? &tree_options.evaluation() : nullptr);
  }
  const Plan& plan = c.choice.plan;
  if (!action.server_side_decision()) return execute_plan(c, plan, plan.best) || hold(c);
  switch (c.choice.chooser) {
    case PlanChoice::Chooser::kPlaymaker:
    case PlanChoice::Chooser::kRequested:
      c.choice.chooser = PlanChoice::Chooser::kRequested;
      return true;
    case PlanChoice::Chooser::kReplied:
      if (c.choice.node < 0) return false;
      return execute_plan(c, plan, first_action_of(plan, c.choice.node)) || hold(c);
    case PlanChoice::Chooser::kProxy:
      break;
  }
  return execute_plan(c, plan, plan.best) || hold(c);
}

}  // namespace cls::proxy
