// Implements running and turning.
#include "player/movement/movement.h"

#include <algorithm>
#include <cmath>

#include "player/looking/looking.h"
#include "player/world/leg_dash.h"
#include "player/world/motion.h"
#include "soccer/pitch.h"

namespace cls::player {
namespace {

double payable_power(const WorldModel& world, double power, bool save_recovery) {
  return save_recovery ? safe_dash_power(world, power) : power;
}

/// Displacement within the horizon per unit of velocity.
double travel_per_speed(const WorldModel& world, int horizon) {
  const double decay = world.self_type().player_decay;
  return (1.0 - power_of(decay, horizon)) / (1.0 - decay);
}

/// Intermediate target that avoids a goal post.
Vec2 around_posts(const WorldModel& world, Vec2 from, Vec2 target) {
  const double clearance = world.self_type().player_size + soccer::kGoalPostRadius + 0.2;
  const Vec2 post{std::copysign(soccer::kHalfLength - soccer::kGoalPostRadius, from.x),
                  std::copysign(world.server().goal_width / 2.0 + soccer::kGoalPostRadius, from.y)};
  if (distance(post, target) < clearance || distance(post, from) > 15.0) return target;
  if (distance(soccer::Segment{from, target}, post) > clearance) return target;

  // Pass the post on the side of the direct path.
  const Vec2 way = target - from;
  const Vec2 left = soccer::with_length({way.y, -way.x}, clearance + 0.3);
  const double side = cross(way, post - from) > 0.0 ? 1.0 : -1.0;
  return post + left * side;
}

/// True if our team takes the next kick-off: after conceding, otherwise left and right alternate by
/// half.
bool we_kick_off(const WorldModel& world) {
  if (world.game.mode != PlayMode::kBeforeKickOff) return world.game.mode_side() != world.our_side;
  const int half = world.server().half_time_cycles();
  const bool left = half <= 0 || world.game.time.cycle / half % 2 == 0;
  return (world.our_side == Side::kLeft) == left;
}

/// Near the target: dash directly in its direction if three dashes suffice.
bool omni_dash(const WorldModel& world, CommandSlots& slots, Vec2 needed, double max_power,
               const RunOptions& options) {
  constexpr int kMaxDashes = 3;
  const AngleDeg direction = AngleDeg::of(needed) - world.self.body;
  const double rate =
      dash_rate(world.server(), direction.degrees()) * world.self_type().dash_power_rate;

  const double power = needed.length() / (rate * world.self.effort);
  const double allowed = payable_power(world, max_power, options.save_recovery);
  if (power > allowed * kMaxDashes) return false;
  return slots.dash(std::min(power, allowed), direction.degrees());
}

/// Turns toward the target while dashing, where that is better than a turn.
bool turn_while_dashing(const WorldModel& world, CommandSlots& slots, double angle, double dist,
                        double max_power, const RunOptions& options) {
  // Nearer, the speed that is left in the old direction carries the agent past the target.
  constexpr double kMinDistance = 1.5;
  if (!world.leg_dashes || dist < kMinDistance) return false;
  const bool hurry = max_power >= 0.9 * world.server().max_dash_power;
  const double allowed = payable_power(world, max_power, options.save_recovery);
  const std::optional<LegTurn> turn = useful_leg_turn(world, angle, allowed, hurry);
  return turn && slots.dash(turn->legs);
}

/// True if dashing backward is better than turning: target near and behind, enough stamina.
bool better_backwards(const WorldModel& world, double dist, double error) {
  return dist < 2.0 && error > 90.0 && error > max_turn(world) &&
         world.self.stamina > world.server().stamina_max * 0.5;
}

}  // namespace

bool go_to_point(const WorldModel& world, CommandSlots& slots, Vec2 target, double threshold,
                 double max_dash_power, RunOptions options) {
  const SelfState& self = world.self;
  const double travel = travel_per_speed(world, options.horizon);
  const Vec2 coasted = self.position + self.velocity * travel;
  if (max_dash_power < 0.1 || distance(target, coasted) < threshold) {
    slots.turn(0.0);
    return false;
  }

  target = around_posts(world, self.position, target);
  const Vec2 missing = target - coasted;
  const double dist = missing.length();
  const AngleDeg direction = AngleDeg::of(missing) - self.body;
  const Vec2 needed = missing / travel;
  const double sideways = std::fabs(math::sin(direction.radians())) * dist;
  const bool beside = sideways >= threshold || direction.abs() > 90.0;

  if (dist < threshold + 1.0 && beside &&
      omni_dash(world, slots, needed, max_dash_power, options)) {
    return true;
  }

  double margin = options.turn_margin_deg;
  if (dist > threshold) margin = std::max(margin, math::to_degrees(math::asin(threshold / dist)));

  if (direction.abs() > margin) {
    return (better_backwards(world, dist, direction.abs()) &&
            omni_dash(world, slots, needed, max_dash_power, options)) ||
           turn_while_dashing(world, slots, direction.degrees(), dist, max_dash_power, options) ||
           slots.turn(direction.degrees());
  }

  const double forward = needed.length() * math::cos(direction.radians());
  constexpr double kMinAcceleration = 0.05;
  if (forward < kMinAcceleration) return false;
  const double power = forward / (world.self_type().dash_power_rate * self.effort);
  return slots.dash(payable_power(world, std::min(power, max_dash_power), options.save_recovery));
}

bool go_to_point_dodge(const WorldModel& world, CommandSlots& slots, Vec2 target,
                       double dash_power) {
  constexpr double kNear = 2.5;  // farther than in helios: turning takes about a meter
  const double size = world.self_type().player_size;
  const Vec2 from = world.self.position;
  const Vec2 way = target - from;
  const double length = way.length();
  if (length < 0.1) return go_to_point(world, slots, target, 0.1, dash_power, {3});

  Vec2 aim = target;
  double nearest = std::min(kNear, length);
  const auto avoid = [&](Vec2 obstacle) {
    const Vec2 relative = obstacle - from;
    const double ahead = dot(relative, way) / length;
    const double beside = cross(way, relative) / length;
    if (ahead <= 0.0 || ahead >= nearest || std::fabs(beside) > 2.0 * size + 0.1) return;
    nearest = ahead;
    const Vec2 left = soccer::with_length({way.y, -way.x}, 4.0 * size);
    aim = obstacle + left * (beside > 0.0 ? 1.0 : -1.0);
  };

  for (const PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns}) {
    for (const PlayerState& player : *list) {
      if (player.position_valid() && player.dist_from_self < kNear) avoid(player.position);
    }
  }

  if (world.game.mode != PlayMode::kPlayOn) avoid(world.ball.position);
  return go_to_point(world, slots, aim, 0.1, dash_power, {3});
}

bool go_to_point_look_ball(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                           NeckPlan& neck, Vec2 target, double threshold, double max_dash_power) {
  const SelfState& self = world.self;
  const Vec2 rest = rest_point(self.position, self.velocity, world.self_type().player_decay);

  if (!world.ball.position_valid()) {
    return go_to_point(world, slots, target, threshold, max_dash_power);
  }
  if (distance(rest, target) < threshold) {
    if (world.ball.pos_count > 5) return body_neck_to_ball(world, view, slots);
    neck.kind = NeckPlan::Kind::kBall;
    return slots.turn(0.0);
  }

  const AngleDeg travel = AngleDeg::of(target - rest);
  const AngleDeg ball = AngleDeg::of(ball_after(world, 1) - self_after(world, 1));
  if ((ball - travel).abs() < world.server().maxneckang - 5.0) {
    if (!go_to_point(world, slots, target, threshold, max_dash_power)) {
      neck_body_to_ball(world, view, slots, 0.0);
      return false;
    }
    neck.kind = NeckPlan::Kind::kBall;
    return true;
  }

  const double margin =
      std::max(6.0, math::to_degrees(math::atan2(threshold, distance(target, rest))));
  const AngleDeg wanted_body = travel + 180.0;
  if ((wanted_body - self.body).abs() > margin) {
    slots.turn((wanted_body - self.body).degrees());
  } else {
    const double needed = distance(target, rest) / travel_per_speed(world, 100);
    const double rate = dash_rate(world.server(), 180.0) * world.self_type().dash_power_rate;
    const double power = std::min(needed / (rate * self.effort), max_dash_power);
    slots.dash(safe_dash_power(world, power), 180.0);
  }

  neck.kind = NeckPlan::Kind::kBall;
  return slots.has_body();
}

bool stop_dash(const WorldModel& world, CommandSlots& slots, bool save_recovery) {
  const SelfState& self = world.self;
  if (!self.velocity_valid()) {
    slots.turn(0.0);
    return false;
  }

  const AngleDeg against = AngleDeg::of(-self.velocity) - self.body;
  const double rate =
      dash_rate(world.server(), against.degrees()) * world.self_type().dash_power_rate;
  const double needed = self.velocity.length() / (rate * self.effort);
  const double power =
      payable_power(world, std::min(needed, world.server().max_dash_power), save_recovery);

  if (!(power < 1.0)) return slots.dash(power, against.degrees());
  slots.turn(0.0);
  return false;
}

bool turn_to_angle(const WorldModel& world, CommandSlots& slots, AngleDeg angle) {
  if (!world.self.face_valid()) return false;
  return slots.turn((angle - world.self.body).degrees());
}

bool turn_to_point(const WorldModel& world, CommandSlots& slots, Vec2 point, int cycles) {
  if (!world.self.position_valid() || !world.self.face_valid()) return slots.turn(60.0);
  const Vec2 from = self_after(world, std::clamp(cycles, 0, 1000));
  const AngleDeg error = AngleDeg::of(point - from) - world.self.body;
  return slots.turn(error.degrees()) && error.abs() >= 1.0;
}

bool turn_to_ball(const WorldModel& world, CommandSlots& slots, int cycles) {
  if (!world.ball.position_valid()) return false;
  return turn_to_point(world, slots, ball_after(world, std::clamp(cycles, 0, 1000)), cycles);
}

bool before_kick_off(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                     Vec2 point) {
  const GameState& game = world.game;
  if (game.time.cycle == 0 && game.time.stopped < 5) {
    slots.turn(0.0);
    return false;
  }

  if (!world.self.position_valid()) return scan_field(world, view, slots);
  const bool after_goal = game.mode != PlayMode::kBeforeKickOff;
  if (after_goal && world.self.velocity.length() > 0.05) return slots.turn(180.0);
  if (world.server().forbid_kick_off_offside) point.x = std::min(point.x, -0.01);

  // Only the team with the kick-off may enter the center circle.
  const double reach = soccer::kCenterCircleRadius + 0.1;
  if (!we_kick_off(world) && point.length() < reach) {
    const Vec2 outwards = point.length() < 0.1 ? Vec2{-1.0, 0.0} : point;
    point = soccer::with_length(outwards, reach + 0.4);
  }

  if (distance(world.self.position, point) > 1.0 && slots.move(point)) {
    slots.turn_neck(-world.self.neck.degrees());
    return true;
  }
  return look_around(world, view, slots);
}

}  // namespace cls::player
