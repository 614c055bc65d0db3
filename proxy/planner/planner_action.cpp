// Plan, choose, act.
#include "proxy/planner/planner_action.h"

#include "proto/playmaker.pb.h"
#include "proxy/ball_skills/hold_ball.h"
#include "proxy/planner/field.h"
#include "proxy/planner/planned_action.h"
#include "proxy/planner/planner_messages.h"
#include "proxy/planner/search.h"

namespace cls::proxy {
namespace {

/// The wish that the tree of this decision is made by.
const protos::HeliosOffensivePlanner& ruling_wish(const protos::HeliosOffensivePlanner& wish,
                                                  const ActionContext& c) {
  if (c.reply == nullptr) return wish;
  for (const protos::PlayerAction& action : c.reply->actions()) {
    if (action.has_helios_offensive_planner()) return action.helios_offensive_planner();
  }
  return wish;
}

bool hold(ActionContext& c) {
  c.neck.kind = NeckPlan::Kind::kScan;
  return hold_ball(c.world, c.slots, false, {});
}

}  // namespace

bool offensive_planner(const protos::HeliosOffensivePlanner& wish, ActionContext& c) {
  if (!c.world.self.kickable || c.world.self.frozen()) return false;
  const protos::HeliosOffensivePlanner& ruling = ruling_wish(wish, c);
  if (c.choice.plan.empty()) {
    const int held = c.memory.ball_since < 0 ? 0 : c.world.game.time.cycle - c.memory.ball_since;
    const PlannerField field(c.world, held);
    c.choice.plan = make_plan(field, planner_options(ruling),
                              ruling.has_evaluation() ? &ruling.evaluation() : nullptr);
  }
  const Plan& plan = c.choice.plan;
  if (!wish.server_side_decision()) return act_on_plan(c, plan, plan.best) || hold(c);
  switch (c.choice.chooser) {
    case PlanChoice::Chooser::kOpen:
    case PlanChoice::Chooser::kWanted:
      c.choice.chooser = PlanChoice::Chooser::kWanted;
      return true;
    case PlanChoice::Chooser::kAnswered:
      if (c.choice.node < 0) return false;
      return act_on_plan(c, plan, first_action_of(plan, c.choice.node)) || hold(c);
    case PlanChoice::Chooser::kProxy:
      break;
  }
  return act_on_plan(c, plan, plan.best) || hold(c);
}

}  // namespace cls::proxy
