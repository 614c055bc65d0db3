// Queued looks.
#include "proxy/looking/neck_plan.h"

#include "proxy/looking/neck.h"

namespace cls::proxy {

bool carry_out(const NeckPlan& plan, const WorldModel& world, const SightMemory& sight,
               CommandSlots& slots) {
  switch (plan.kind) {
    case NeckPlan::Kind::kNone:
      return false;
    case NeckPlan::Kind::kBall:
      return neck_turn_to_ball(world, sight, slots);
    case NeckPlan::Kind::kBallOrScan:
      return neck_turn_to_ball_or_scan(world, sight, slots, 0);
    case NeckPlan::Kind::kScan:
      return neck_scan_field(world, sight, slots);
    case NeckPlan::Kind::kPoint:
      return neck_turn_to_point(world, sight, slots, plan.point);
    case NeckPlan::Kind::kGoalieOrScan:
      return neck_turn_to_goalie_or_scan(world, sight, slots, 0);
    case NeckPlan::Kind::kOffensiveIntercept:
      return neck_offensive_intercept(world, sight, slots);
  }
  return false;
}

}  // namespace cls::proxy
