// Pass, or at least away.
#include "proxy/behaviors/kick_into_play.h"

#include <algorithm>

#include "proxy/ball_skills/clear_ball.h"
#include "proxy/ball_skills/kick.h"
#include "proxy/planner/field.h"
#include "proxy/planner/outlet.h"
#include "proxy/planner/planned_action.h"
#include "proxy/planner/search.h"
#include "proxy/world/motion.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

using soccer::Vec2;

/// The nearest teammate between 8 and 25 m with nobody close to it.
const PlayerState* free_mate(const WorldModel& world) {
  constexpr double kRoom = 3.0;
  const PlayerState* best = nullptr;
  for (const PlayerState& mate : world.teammates) {
    if (mate.pos_count > 10 || mate.ghost() || mate.goalie || mate.position.x < -40.0) continue;
    if (mate.dist_from_ball < 8.0 || mate.dist_from_ball > 25.0) continue;
    const bool covered = std::any_of(
        world.opponents.begin(), world.opponents.end(), [&](const PlayerState& opponent) {
          return opponent.position_valid() && distance(opponent.position, mate.position) < kRoom;
        });
    if (covered) continue;
    if (best == nullptr || mate.dist_from_ball < best->dist_from_ball) best = &mate;
  }
  return best;
}

}  // namespace

bool play_planned_pass(ActionContext& c) {
  if (!c.world.self.kickable) return false;
  const PlannerField field(c.world);
  PlannerOptions options;
  options.short_dribble = options.long_dribble = false;
  const Plan plan = make_plan(field, options, nullptr);
  const int first = plan.first_of(plan.best);
  if (plan.nodes[static_cast<std::size_t>(first)].action.category != PlanCategory::kPass) {
    // Holding is no choice for a dead ball: the best pass there is.
    int best = 0;
    for (std::size_t i = 1; i < plan.nodes.size(); ++i) {
      const bool pass = plan.nodes[i].depth == 1;
      if (pass &&
          (best == 0 || plan.nodes[i].value > plan.nodes[static_cast<std::size_t>(best)].value)) {
        best = static_cast<int>(i);
      }
    }
    return best != 0 && act_on_plan(c, plan, best);
  }
  return act_on_plan(c, plan, plan.best);
}

bool kick_outlet(ActionContext& c) {
  const WorldModel& world = c.world;
  if (!world.self.kickable) return false;
  const PlannerField field(world);
  const std::optional<Outlet> outlet = best_outlet(field);
  if (!outlet) return clear_ball(world, c.slots);
  c.neck.kind = NeckPlan::Kind::kScan;
  return kick_one_step(world, c.slots, outlet->target, outlet->speed, true);
}

bool kick_into_play(ActionContext& c) {
  const WorldModel& world = c.world;
  if (!world.self.kickable) return false;
  if (play_planned_pass(c)) return true;
  c.neck.kind = NeckPlan::Kind::kScan;
  if (const PlayerState* mate = free_mate(world)) {
    constexpr double kArrival = 1.2;
    const double decay = world.server().ball_decay;
    const double speed = kArrival + mate->dist_from_ball * (1.0 - decay);
    return kick_one_step(world, c.slots, mate->position, speed, true);
  }
  return advance_ball(world, c.slots);
}

}  // namespace cls::proxy
