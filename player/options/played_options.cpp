// From plans, kicks and dribbles to options.
#include "player/options/played_options.h"

#include <cmath>
#include <limits>

#include "base/index.h"
#include "player/options/option_classes.h"
#include "player/planner/field.h"
#include "player/planner/plan_execution.h"
#include "soccer/geometry.h"
#include "soccer/pitch.h"

namespace cls::player {
namespace {

/// A kick and a candidate that end within this distance are the same, meters.
constexpr double kSamePoint = 3.0;
/// A kick that ends within this distance of a teammate is a pass to it, meters.
constexpr double kNearReceiver = 5.0;
/// Dribbles whose directions differ less are alike, degrees.
constexpr double kSameDirection = 45.0;

bool is_at_goal(const WorldModel& world, Vec2 target) {
  const Vec2 ball = world.ball.position;
  if (target.x < soccer::kHalfLength || ball.x >= soccer::kHalfLength) return false;
  const double share = (soccer::kHalfLength - ball.x) / (target.x - ball.x);
  const double y = ball.y + share * (target.y - ball.y);
  return std::abs(y) <= world.server().goal_width / 2.0;
}

/// The teammate who is nearest to `target`; 0: none is near it.
int receiver_near(const PlannerField& field, Vec2 target) {
  int receiver = 0;
  double nearest = kNearReceiver;
  for (const FieldPlayer& mate : field.teammates) {
    const double away = distance(mate.position, target);
    if (mate.unum == 0 || away > nearest) continue;
    receiver = mate.unum;
    nearest = away;
  }
  return receiver;
}

bool is_legal(const OptionTable& table, int id) { return table.legal[base::index(id)]; }

}  // namespace

int option_of_plan(const WorldModel& world, const OptionTable& table, const Plan& plan, int node) {
  if (plan.empty()) return kClearOption;
  const PlanAction& action = plan.at(plan.first_of(node)).action;
  if (const int id = option_class(world, action); id >= 0) return id;
  if (world.game.mode != PlayMode::kPlayOn) return kHoldOption;

  switch (hold_kind(world, table.ball_since)) {
    case HoldKind::kShoot:
      return kShootOption;
    case HoldKind::kLayOff:
      return kLayOffOption;
    case HoldKind::kKeep:
      break;
  }
  return kHoldOption;
}

int option_of_kick(const WorldModel& world, const OptionTable& table, Vec2 target) {
  if (is_at_goal(world, target)) {
    return is_legal(table, kShootOption) ? kShootOption : kClearOption;
  }

  const PlannerField field(world, table.held(world));
  const int receiver = receiver_near(field, target);
  int same = -1;
  int to_receiver = -1;
  double nearest = kSamePoint;
  double nearest_to_receiver = std::numeric_limits<double>::infinity();
  for (const PlanAction& action : ball_candidates(field)) {
    const int id = option_class(world, action);
    const double away = distance(action.target_point, target);
    if (id < 0) continue;
    if (away < nearest) {
      same = id;
      nearest = away;
    }
    if (id >= kPassOption && action.target == receiver && away < nearest_to_receiver) {
      to_receiver = id;
      nearest_to_receiver = away;
    }
  }
  return same >= 0 ? same : to_receiver;
}

int option_of_dribble(const WorldModel& world, const OptionTable& table, Vec2 target) {
  const AngleDeg wanted = AngleDeg::of(target - world.ball.position);
  int best = -1;
  double nearest = kSameDirection;
  for (int turn = 0; turn < kDribbleDirections; ++turn) {
    const AngleDeg direction(360.0 / kDribbleDirections * turn - 180.0);
    const double away = std::abs((direction - wanted).degrees());
    if (!is_legal(table, kDribbleOption + turn) || away >= nearest) continue;
    best = kDribbleOption + turn;
    nearest = away;
  }
  return best;
}

}  // namespace cls::player
