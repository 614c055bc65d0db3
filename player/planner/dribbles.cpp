// Generates dribbles of the agent: short dribbles and self passes.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/index.h"
#include "player/planner/generator_parameters.h"
#include "player/planner/generators.h"
#include "player/world/leg_dash.h"
#include "player/world/motion.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

constexpr DribbleSearchParameters kNumbers = kGenerators.dribble;
constexpr int kMaxDashes = 20;

/// The turn between kick and dashes.
struct TurnPart {
  int turns = 0;
  Vec2 acceleration;  ///< of a two-leg dash
  bool dashes() const { return !acceleration.is_zero(); }
};

/// Agent positions by cycle from now: one kick, turns, full dashes. A turn may be a two-leg dash.
struct Course {
  std::array<Vec2, kMaxDashes + 4> positions;
  int steps = 0;

  Vec2 end() const { return positions[base::index(steps)]; }
};

Course course_of(const WorldModel& world, AngleDeg heading, const TurnPart& turn, int dashes) {
  Course course;
  const soccer::PlayerType& type = world.self_type();

  Vec2 position = world.self.position;
  Vec2 velocity = world.self.velocity;
  course.positions[0] = position;
  course.steps = 1 + turn.turns + dashes;
  const Vec2 push = dash_acceleration(world, heading, world.server().max_dash_power, 0.0);

  for (int cycle = 1; cycle <= course.steps; ++cycle) {
    if (cycle > 1 + turn.turns) {
      velocity = speed_limited(velocity + push, type.player_speed_max);
    } else if (cycle == 2) {
      velocity = speed_limited(velocity + turn.acceleration, type.player_speed_max);
    }
    position += velocity;
    velocity *= type.player_decay;
    course.positions[base::index(cycle)] = position;
  }

  return course;
}

/// Turns until the body points along `heading`, starting in the cycle after the kick.
TurnPart turns_needed(const WorldModel& world, AngleDeg heading) {
  const soccer::PlayerType& type = world.self_type();
  const double angle = (heading - world.self.body).degrees();
  if (const auto turn = useful_leg_turn(world, angle, world.server().max_dash_power, true)) {
    return {1, turn->acceleration};
  }

  double missing = std::fabs(angle);
  Vec2 velocity = world.self.velocity * type.player_decay;

  int turns = 0;
  constexpr double kStraight = 1.0;
  while (missing > kStraight && turns < 4) {
    missing -= world.server().maxmoment / turn_resistance(type, velocity);
    velocity *= type.player_decay;
    ++turns;
  }

  return {turns, {}};
}

bool enough_stamina(const PlannerField& field, int dashes) {
  const WorldModel& world = field.world;
  const double threshold = world.server().recover_dec_thr * world.server().stamina_max +
                           field.parameters.dribble_reserve;
  const double income = world.self_type().stamina_inc_max * world.self.recovery;
  const double cost = dashes * std::max(0.0, world.server().max_dash_power - income);
  return world.self.stamina - cost > threshold;
}

/// True if the ball collides with the agent.
bool hits_self(const PlannerField& field, const Course& course, Vec2 velocity) {
  const double clear = collide_distance(field.world) + kNumbers.body_gap;

  for (int cycle = 1; cycle < course.steps; ++cycle) {
    const Vec2 ball = field.ball + velocity * field.roll(cycle);
    if (squared_distance(ball, course.positions[base::index(cycle)]) < clear * clear) return true;
  }

  return false;
}

/// The dribble along a course to `end` if one kick suffices, and neither the agent nor an opponent
/// with that extra reach stops the ball.
std::optional<PlanAction> dribble_to(const PlannerField& field, PlanTag tag, Vec2 end,
                                     AngleDeg heading, const Course& course, int turns,
                                     double extra_reach) {
  const Vec2 velocity = (end - field.ball) / field.roll(course.steps);
  const double length = velocity.length();
  if (length > field.world.server().ball_speed_max) return std::nullopt;
  if ((velocity - field.ball_velocity).length() > field.kick_limit) return std::nullopt;
  if (hits_self(field, course, velocity)) return std::nullopt;
  if (length > 1e-6 &&
      is_stopped(field, {velocity / length, length, course.steps}, {.extra_reach = extra_reach})) {
    return std::nullopt;
  }

  return PlanAction{.category = PlanCategory::kDribble,
                    .tag = tag,
                    .sender = field.self.unum,
                    .target = field.self.unum,
                    .target_point = end,
                    .first_speed = length,
                    .first_velocity = velocity,
                    .turn = (heading - field.world.self.body).degrees(),
                    .duration = course.steps,
                    .kicks = 1,
                    .turns = turns,
                    .dashes = course.steps - 1 - turns};
}

/// True if an opponent can reach the end of a short dribble in time.
bool short_dribble_spoiled(const PlannerField& field, Vec2 end, AngleDeg heading, int cycles) {
  const Vec2 here = field.self.position;
  const Vec2 ahead = soccer::polar(1.0, heading);

  int bonus = field.parameters.short_dribble_head_start;
  if (end.x < 30.0) ++bonus;
  if (end.x < 0.0) ++bonus;

  for (const FieldOpponent& opponent : field.opponents) {
    const Vec2 relative = opponent.position - here;
    if (relative.squared_length() > 20.0 * 20.0) continue;
    if (dot(relative, ahead) < -4.0) continue;
    const int credit = bonus + std::min(opponent.age, end.x < 0.0 ? 8 : 4);
    if (cycles_to_get(opponent, end) <= cycles + credit) return true;
  }
  return false;
}

}  // namespace

void add_short_dribbles(const PlannerField& field, std::vector<PlanAction>& out) {
  const WorldModel& world = field.world;
  if (!field.open_play) return;

  constexpr int kDirections = 16;
  const double radius =
      collide_distance(world) + kNumbers.near_radius * world.self_type().kickable_margin;
  const bool near_own_goal = world.self.position.x < -36.0 && std::fabs(world.self.position.y) < 20;

  for (int i = 0; i < kDirections; ++i) {
    const AngleDeg heading = world.self.body + 360.0 * i / kDirections;
    if (heading.abs() > kNumbers.back_angle && world.self.position.x < kNumbers.back_x) continue;
    if (heading.abs() > 45.0 && near_own_goal &&
        (world.self.position.y < 0.0) != (heading.degrees() < 0.0)) {
      continue;
    }

    const TurnPart turning = turns_needed(world, heading);
    if (turning.turns > 2) continue;
    for (int dashes = 4; dashes >= 2; --dashes) {
      if (!enough_stamina(field, dashes + (turning.dashes() ? 1 : 0))) continue;
      const Course course = course_of(world, heading, turning, dashes);
      const Vec2 end = course.end() + soccer::polar(radius, heading);
      if (outside_pitch(end, kNumbers.inset)) continue;
      if (short_dribble_spoiled(field, end, heading, course.steps)) continue;

      const auto action = dribble_to(field, PlanTag::kShortDribble, end, heading, course,
                                     turning.turns, field.parameters.short_dribble_margin);
      if (action) out.push_back(*action);
    }
  }
}

void add_self_passes(const PlannerField& field, std::vector<PlanAction>& out) {
  const WorldModel& world = field.world;
  if (!field.open_play) return;

  const double x = field.ball.x;
  const int max_dashes = x < -20.0 ? 6 : x < 0.0 ? 7 : x < 10.0 ? 13 : x < 20.0 ? 15 : 20;
  const double radius =
      collide_distance(world) + kNumbers.far_radius * world.self_type().kickable_margin;
  const double max_turn =
      world.server().maxmoment /
      turn_resistance(world.self_type(), world.self.velocity * world.self_type().player_decay);

  for (int i = 0; i < 60; ++i) {
    const AngleDeg heading(6.0 * i);
    const double off = (heading - world.self.body).abs();
    if (heading.abs() > kNumbers.long_back_angle && x < kNumbers.long_back_x) continue;
    TurnPart turning{off > 1.0 ? 1 : 0, {}};
    if (world.leg_dashes) turning = turns_needed(world, heading);
    if (turning.turns > 1 || (off > max_turn && !turning.dashes())) continue;

    int found = 0;
    for (int dashes = max_dashes;
         dashes >= field.parameters.self_pass_dashes && found < kNumbers.long_per_heading;
         --dashes) {
      if (!enough_stamina(field, dashes + (turning.dashes() ? 1 : 0))) continue;
      const Course course = course_of(world, heading, turning, dashes);
      const Vec2 end = course.end() + soccer::polar(radius, heading);
      if (std::fabs(end.x) > soccer::kHalfLength - kNumbers.long_inset_x ||
          std::fabs(end.y) > soccer::kHalfWidth - kNumbers.long_inset_y ||
          distance(end, kOwnGoal) < kNumbers.own_goal) {
        continue;
      }

      const auto action = dribble_to(field, PlanTag::kSelfPass, end, heading, course, turning.turns,
                                     field.parameters.self_pass_margin);
      if (!action || opponent_gets_there(field, end, course.steps, true)) continue;
      out.push_back(*action);
      ++found;
    }
  }
}

}  // namespace cls::player
