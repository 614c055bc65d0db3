// Draws drivers, and decides as agents do, without a Playmaker's messages.
#include "training/npc/driver.h"

#include "player/behaviors/automatic_play.h"
#include "player/behaviors/behaviors.h"
#include "player/options/options.h"
#include "player/perception/perception.h"
#include "player/planner/plan_execution.h"

namespace cls::training {
namespace {

using player::ActionContext;

void play_by_planner(ActionContext& context) {
  if (play_without_choice(context)) return;
  if (!context.world.self.kickable) {
    basic_move(context);
    return;
  }
  const player::Plan& plan = plan_of_decision(context, planner_options());
  if (!kick_out_of_danger(context)) execute_plan_or_hold(context, plan, plan.best);
}

}  // namespace

int draw_driver(const DriverPool& pool, soccer::RandomStream& random) {
  double left = 0.0;
  for (const DriverShare& share : pool) left += share.weight;
  left *= random.unit();

  int last = -1;  // with a positive weight
  for (std::size_t i = 0; i < pool.size(); ++i) {
    if (pool[i].weight <= 0.0) continue;
    last = static_cast<int>(i);
    left -= pool[i].weight;
    if (left < 0.0) break;
  }
  return last;
}

player::PlannerOptions planner_options() {
  player::PlannerOptions options;
  options.simple_pass = true;
  options.simple_dribble = true;
  return options;
}

void decide(Driver driver, MatchPlayer& player) {
  decide_with(
      [driver](ActionContext& context) {
        if (driver == Driver::kMock) {
          play_as_simple_team(context);
        } else {
          play_by_planner(context);
        }
      },
      player);
}

void decide_with(const std::function<void(ActionContext&)>& choose, Perceiver& senses,
                 player::ActionMemory& memory) {
  player::CommandSlots slots(senses.world);
  player::NeckPlan neck;
  player::ActionReport report;
  player::PlanChoice choice;
  ActionContext context{senses.world, memory, slots, neck, report, choice};

  begin_decision(context);
  choose(context);
  finish_decision(context);
  slots.compose(senses.commands);
  record_sent_commands(senses.world, senses.commands);
}

}  // namespace cls::training
