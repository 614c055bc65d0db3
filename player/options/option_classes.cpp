// From candidates to the ids of their classes.
#include "player/options/option_classes.h"

#include <cmath>

#include "player/planner/generators.h"
#include "soccer/geometry.h"

namespace cls::player {
namespace {

/// Index among the players of the team without the agent; -1 if the number is not one of them.
int receiver_of(const WorldModel& world, int unum) {
  if (unum < 1 || unum > soccer::kPlayersPerTeam || unum == world.unum) return -1;
  return unum - 1 - (unum > world.unum ? 1 : 0);
}

PassKind pass_kind(PlanTag tag) {
  switch (tag) {
    case PlanTag::kStrictLead:
      return PassKind::kAhead;
    case PlanTag::kStrictThrough:
      return PassKind::kThrough;
    case PlanTag::kCross:
      return PassKind::kCross;
    default:
      return PassKind::kFeet;
  }
}

/// The option of a dribble from the ball towards `target`.
int dribble_option(const WorldModel& world, Vec2 target) {
  const double direction = AngleDeg::of(target - world.ball.position).degrees();
  const int turn = static_cast<int>(std::lround((direction + 180.0) * kDribbleDirections / 360.0));
  return kDribbleOption + turn % kDribbleDirections;
}

}  // namespace

std::vector<PlanAction> ball_candidates(const PlannerField& field) {
  std::vector<PlanAction> actions;
  add_passes(field, actions);
  add_crosses(field, actions);
  add_short_dribbles(field, actions);
  add_self_passes(field, actions);
  return actions;
}

int option_class(const WorldModel& world, const PlanAction& action) {
  if (action.category == PlanCategory::kDribble) return dribble_option(world, action.target_point);
  if (action.category != PlanCategory::kPass) return -1;
  const int receiver = receiver_of(world, action.target);
  return receiver < 0 ? -1 : pass_option(receiver, pass_kind(action.tag));
}

}  // namespace cls::player
