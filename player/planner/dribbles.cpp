// Generates dribbles of the agent: short dribbles and self passes.
#include <algorithm>
#include <array>
#include <cmath>

#include "player/planner/generators.h"
#include "player/world/leg_dash.h"
#include "player/world/motion.h"
#include "soccer/pitch.h"

namespace cls::player {
namespace {

using soccer::AngleDeg;
using soccer::Vec2;

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
    course.positions[static_cast<std::size_t>(cycle)] = position;
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
  const double clear = collide_distance(field.world) + 0.05;

  for (int cycle = 1; cycle < course.steps; ++cycle) {
    const Vec2 ball = field.ball + velocity * field.roll(cycle);
    if (squared_distance(ball, course.positions[static_cast<std::size_t>(cycle)]) < clear * clear) {
      return true;
    }
  }

  return false;
}

PlanAction dribble(const PlannerField& field, PlanTag tag, Vec2 end, Vec2 velocity, double turn,
                   int turns, int dashes) {
  PlanAction action;

  action.category = PlanCategory::kDribble;
  action.tag = tag;
  action.sender = action.target = field.self.unum;
  action.target_point = end;
  action.first_velocity = velocity;
  action.first_speed = velocity.length();
  action.turn = turn;
  action.kicks = 1;
  action.turns = turns;
  action.dashes = dashes;
  action.duration = 1 + turns + dashes;

  return action;
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
  const double radius = collide_distance(world) + 0.2 * world.self_type().kickable_margin;
  const bool near_own_goal = world.self.position.x < -36.0 && std::fabs(world.self.position.y) < 20;

  for (int i = 0; i < kDirections; ++i) {
    const AngleDeg heading = world.self.body + 360.0 * i / kDirections;
    if (heading.abs() > 100.0 && world.self.position.x < 16.0) continue;
    if (heading.abs() > 45.0 && near_own_goal &&
        (world.self.position.y < 0.0) != (heading.degrees() < 0.0)) {
      continue;
    }

    const TurnPart turning = turns_needed(world, heading);
    const int turns = turning.turns;
    if (turns > 2) continue;
    for (int dashes = 4; dashes >= 2; --dashes) {
      if (!enough_stamina(field, dashes + (turning.dashes() ? 1 : 0))) continue;
      const Course course = course_of(world, heading, turning, dashes);
      const Vec2 end =
          course.positions[static_cast<std::size_t>(course.steps)] + soccer::polar(radius, heading);
      if (std::fabs(end.x) > soccer::kHalfLength - 1.0 ||
          std::fabs(end.y) > soccer::kHalfWidth - 1.0) {
        continue;
      }

      const Vec2 velocity = (end - field.ball) / field.roll(course.steps);
      if (velocity.length() > world.server().ball_speed_max) continue;
      if ((velocity - field.ball_velocity).length() > field.kick_limit) continue;
      if (hits_self(field, course, velocity)) continue;
      if (short_dribble_spoiled(field, end, heading, course.steps)) continue;

      const double length = velocity.length();
      if (length > 1e-6) {
        StopRules rules;
        rules.extra_reach = field.parameters.short_dribble_margin;
        if (is_stopped(field, {velocity / length, length, course.steps}, rules)) continue;
      }

      const double turn = (heading - world.self.body).degrees();
      PlanAction action =
          dribble(field, PlanTag::kShortDribble, end, velocity, turn, turns, dashes);
      out.push_back(action);
    }
  }
}

void add_self_passes(const PlannerField& field, std::vector<PlanAction>& out) {
  const WorldModel& world = field.world;
  if (!field.open_play) return;

  const double x = field.ball.x;
  const int max_dashes = x < -20.0 ? 6 : x < 0.0 ? 7 : x < 10.0 ? 13 : x < 20.0 ? 15 : 20;
  const double radius = collide_distance(world) + 0.4 * world.self_type().kickable_margin;
  const double max_turn =
      world.server().maxmoment /
      turn_resistance(world.self_type(), world.self.velocity * world.self_type().player_decay);

  for (int i = 0; i < 60; ++i) {
    const AngleDeg heading(6.0 * i);
    const double off = (heading - world.self.body).abs();
    if (heading.abs() > 85.0 && x < 41.0) continue;
    TurnPart turning{off > 1.0 ? 1 : 0, {}};
    if (world.leg_dashes) turning = turns_needed(world, heading);
    const int turns = turning.turns;
    if (turns > 1 || (off > max_turn && !turning.dashes())) continue;

    int found = 0;
    for (int dashes = max_dashes; dashes >= field.parameters.self_pass_dashes && found < 10;
         --dashes) {
      if (!enough_stamina(field, dashes + (turning.dashes() ? 1 : 0))) continue;
      const Course course = course_of(world, heading, turning, dashes);
      const Vec2 end =
          course.positions[static_cast<std::size_t>(course.steps)] + soccer::polar(radius, heading);
      const Vec2 own_goal{-soccer::kHalfLength, 0.0};
      if (std::fabs(end.x) > soccer::kHalfLength - 2.5 ||
          std::fabs(end.y) > soccer::kHalfWidth - 3.0 || distance(end, own_goal) < 18.0) {
        continue;
      }

      const Vec2 velocity = (end - field.ball) / field.roll(course.steps);
      if (velocity.length() > world.server().ball_speed_max) continue;
      if ((velocity - field.ball_velocity).length() > field.kick_limit) continue;
      if (hits_self(field, course, velocity)) continue;

      const double length = velocity.length();
      StopRules rules;
      rules.extra_reach = field.parameters.self_pass_margin;
      if (is_stopped(field, {velocity / length, length, course.steps}, rules)) continue;
      if (opponent_gets_there(field, end, course.steps, true)) continue;

      const double turn = (heading - world.self.body).degrees();
      out.push_back(dribble(field, PlanTag::kSelfPass, end, velocity, turn, turns, dashes));
      ++found;
    }
  }
}

}  // namespace cls::player
