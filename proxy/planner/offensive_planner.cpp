// Plans, chooses and executes an action.
#include "proxy/planner/offensive_planner.h"

#include <algorithm>

#include "player/planner/plan_execution.h"
#include "proto/playmaker.pb.h"
#include "proxy/planner/planner_messages.h"
#include "proxy/planner/playmaker_evaluation.h"

namespace cls::proxy {
namespace {

constexpr int kDefaultDepth = 4;
constexpr int kDefaultNodes = 500;
// Limits that keep planning within a cycle.
constexpr int kMaxNodes = 10000;
constexpr int kMaxDepth = 10;

int limited(int wanted, int most, int by_default) {
  return wanted > 0 ? std::min(wanted, most) : by_default;
}

/// The planner action that defines the tree of this decision: the first one in the reply.
const protos::HeliosOffensivePlanner& tree_action(const protos::HeliosOffensivePlanner& action,
                                                  const ReplyContext& c) {
  for (const protos::PlayerAction& each : c.reply.actions()) {
    if (each.has_helios_offensive_planner()) return each.helios_offensive_planner();
  }
  return action;
}

player::NodeValue node_value(const protos::HeliosOffensivePlanner& action) {
  if (!action.has_evaluation()) return player::default_value;
  return [&evaluation = action.evaluation()](const player::PlannerField& field,
                                             const player::Plan& plan, int node) {
    return evaluate(field, plan, node, evaluation);
  };
}

}  // namespace

player::PlannerOptions planner_options(const protos::HeliosOffensivePlanner& action) {
  player::PlannerOptions options;
  options.passes = action.direct_pass() || action.lead_pass() || action.through_pass();
  options.cross = action.cross();
  options.short_dribble = action.short_dribble();
  options.long_dribble = action.long_dribble();
  options.simple_pass = action.simple_pass();
  options.simple_dribble = action.simple_dribble();
  options.simple_shoot = action.simple_shoot();
  options.max_depth = limited(action.max_depth(), kMaxDepth, kDefaultDepth);
  options.max_nodes = limited(action.max_nodes(), kMaxNodes, kDefaultNodes);
  return options;
}

bool run_offensive_planner(const protos::HeliosOffensivePlanner& action, ReplyContext& c) {
  if (!c.world.self.kickable || c.world.self.frozen()) return false;

  const protos::HeliosOffensivePlanner& tree_options = tree_action(action, c);
  const player::Plan& plan =
      plan_of_decision(c, planner_options(tree_options), node_value(tree_options));
  if (!action.server_side_decision()) {
    return (!action.has_evaluation() && kick_out_of_danger(c)) ||
           execute_plan_or_hold(c, plan, plan.best);
  }

  switch (c.choice.chooser) {
    case player::PlanChoice::Chooser::kPlaymaker:
    case player::PlanChoice::Chooser::kRequested:
      c.choice.chooser = player::PlanChoice::Chooser::kRequested;
      return true;
    case player::PlanChoice::Chooser::kReplied:
      if (c.choice.node < 0) return false;
      return execute_plan_or_hold(c, plan, first_action_of(plan, c.choice.node));
    case player::PlanChoice::Chooser::kProxy:
      break;
  }
  return execute_plan_or_hold(c, plan, plan.best);
}

}  // namespace cls::proxy
