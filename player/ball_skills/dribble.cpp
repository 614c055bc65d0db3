// Dribbling: turn, dash, or kick the ball ahead.
#include "player/ball_skills/ball_skills.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/index.h"
#include "player/ball_skills/skill_parameters.h"
#include "player/ball_skills/threats.h"
#include "player/movement/movement.h"
#include "player/world/candidates.h"
#include "player/world/leg_dash.h"
#include "player/world/motion.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

constexpr int kMaxDashes = 10;
constexpr DribbleParameters kNumbers = kSkills.dribble;

/// Minimum distance between the middles of ball and agent.
double clear_distance(const WorldModel& world) {
  return collide_distance(world) + kNumbers.body_gap;
}

/// True if the ball is kickable for a player at `self`, with a noise margin, and does not collide
/// with it.
bool at_feet(const WorldModel& world, Vec2 ball, Vec2 self, double noise) {
  const double dist = distance(ball, self);
  return dist < kickable_area(world) - noise && dist > clear_distance(world);
}

/// Own positions by cycle: kick in this cycle, dashes in the next ones.
std::array<Vec2, kMaxDashes + 2> positions_while_dashing(const WorldModel& world, double power,
                                                         int dashes) {
  std::array<Vec2, kMaxDashes + 2> positions{world.self.position};
  Vec2 position = world.self.position;
  Vec2 velocity = world.self.velocity;
  const Vec2 push = dash_acceleration(world, power, 0.0);

  for (int cycle = 1; cycle <= dashes + 1; ++cycle) {
    if (cycle > 1) velocity = speed_limited(velocity + push, world.self_type().player_speed_max);
    position += velocity;
    velocity *= world.self_type().player_decay;
    positions[base::index(cycle)] = position;
  }

  return positions;
}

/// Velocity with which the ball gets to `end` in `cycles`; zero where it is there.
Vec2 velocity_to(const WorldModel& world, Vec2 end, int cycles) {
  const Vec2 way = end - world.ball.position;
  const double length = way.length();
  if (length < 1e-6) return {};
  return way * (first_speed(length, cycles, world.server().ball_decay) / length);
}

bool exceeds_kick(const WorldModel& world, Vec2 velocity) {
  return (velocity - world.ball.velocity).length() > kick_limit(world);
}

/// The velocity of the best kick after which the agent reaches the ball with `dashes` dashes.
Lowest<Vec2> kick_ahead(const WorldModel& world, const Threats& threats, double power, int dashes) {
  static constexpr std::array<double, 7> kOffsets{0.0, 25.0, -25.0, 50.0, -50.0, 80.0, -80.0};
  const double decay = world.server().ball_decay;
  const auto self = positions_while_dashing(world, power, dashes);
  const int cycles = dashes + 1;
  const double radius =
      collide_distance(world) + kNumbers.feet_share * world.self_type().kickable_margin;

  Lowest<Vec2> best{1e9};
  for (const double offset : kOffsets) {
    const Vec2 end = self[base::index(cycles)] + soccer::polar(radius, world.self.body + offset);
    const Vec2 velocity = velocity_to(world, end, cycles);
    if (velocity.is_zero() || !inside_pitch(end, kNumbers.pitch_inset)) continue;
    if (exceeds_kick(world, velocity)) continue;

    double cost = kNumbers.offset_cost * std::fabs(offset);
    bool clean = velocity.length() <= world.server().ball_speed_max;
    for (int n = 1; n < cycles && clean; ++n) {
      const Vec2 there = coast(world.ball.position, velocity, decay, n);
      clean = distance(there, self[base::index(n)]) > clear_distance(world);
      if (n <= 3) cost += threats.cost(there, n);
    }

    cost += threats.cost(end, std::min(cycles, 3));
    if (clean) best.offer(cost, velocity);
  }

  return best;
}

/// Kicks the ball to a safe point around the body for the time of turning toward `heading`.
bool kick_for_turn(const WorldModel& world, const Threats& threats, CommandSlots& slots,
                   AngleDeg heading, int turns) {
  const int cycles = turns + 1;
  const int horizon = std::min(cycles, 3);
  Lowest<Vec2> best{1e9};

  for (double offset = 0.0; offset < 360.0; offset += 20.0) {
    for (const double share : {0.25, 0.5}) {
      const double radius = collide_distance(world) + share * world.self_type().kickable_margin;
      const Vec2 end = self_after(world, cycles) + soccer::polar(radius, heading + offset);
      const Vec2 velocity = velocity_to(world, end, cycles);
      if (exceeds_kick(world, velocity) || !inside_pitch(end, kNumbers.pitch_inset)) continue;

      const Vec2 next = world.ball.position + velocity;
      if (distance(next, self_after(world, 1)) < clear_distance(world)) continue;
      const double room = std::min(kNumbers.max_turn_room, threats.nearest(end, horizon));
      best.offer(threats.cost(next, 1) + threats.cost(end, horizon) +
                     kNumbers.turn_offset_cost * AngleDeg(offset).abs() - kNumbers.turn_room * room,
                 velocity);
    }
  }

  return best.score < 1e9 && kick_to_velocity(world, slots, best.value);
}

Vec2 next_position(const WorldModel& world, Vec2 acceleration) {
  return world.self.position +
         speed_limited(world.self.velocity + acceleration, world.self_type().player_speed_max);
}

/// Turns, while dashing where that is better.
bool turn_in_dribble(const WorldModel& world, CommandSlots& slots, double angle, double power) {
  const auto turn = useful_leg_turn(world, angle, safe_dash_power(world, power), true);
  return turn ? slots.dash(turn->legs) : slots.turn(angle);
}

bool turn_with_ball(const WorldModel& world, const Threats& threats, CommandSlots& slots,
                    double error, double power) {
  const Vec2 ball = ball_after(world, 1);
  const bool safe = threats.cost(ball, 1) <= kSkills.threat.dash;
  const double noise =
      kNumbers.turn_noise + world.server().ball_rand * world.ball.velocity.length();
  const auto turn = useful_leg_turn(world, error, power, true);
  if (safe && turn &&
      at_feet(world, ball, next_position(world, turn->acceleration),
              noise + kNumbers.leg_turn_noise)) {
    return slots.dash(turn->legs);
  }
  if (safe && at_feet(world, ball, self_after(world, 1), noise)) return slots.turn(error);

  const double next_turn =
      world.server().maxmoment /
      turn_resistance(world.self_type(), world.self.velocity * world.self_type().player_decay);
  const int turns = std::fabs(error) > next_turn ? 2 : 1;

  if (kick_for_turn(world, threats, slots, world.self.body + error, turns)) return true;
  return hold_ball(world, slots, true,
                   world.self.position + soccer::polar(10.0, world.self.body + error));
}

/// True if an opponent is in the corridor ahead.
bool blocked(const WorldModel& world, AngleDeg heading) {
  constexpr double kAhead = 5.0;
  constexpr double kBeside = 1.3;
  const Vec2 way = soccer::polar(1.0, heading);

  for (const PlayerState& opponent : world.opponents) {
    if (opponent.ghost() || opponent.pos_count > 10) continue;
    const Vec2 relative = opponent.position - world.self.position;
    const double ahead = dot(relative, way);
    if (ahead > 0.0 && ahead < kAhead && std::fabs(cross(way, relative)) < kBeside) return true;
  }

  return false;
}

/// Unblocked heading nearest to `heading`; `heading` if all are blocked.
AngleDeg free_heading(const WorldModel& world, AngleDeg heading) {
  for (const double off : {0.0, 20.0, -20.0, 40.0, -40.0, 60.0, -60.0, 80.0, -80.0}) {
    if (!blocked(world, heading + off)) return heading + off;
  }
  return heading;
}

void set_intention(const WorldModel& world, Intention& intention, Vec2 target, double power,
                   int dashes) {
  intention = {.kind = Intention::Kind::kDribble,
               .target = target,
               .heading = world.self.body,
               .dash_power = power,
               .dashes = dashes,
               .last = world.game.time};
}

/// One dash if the ball stays kickable, otherwise a kick followed by up to `dash_count` dashes.
bool run_with_ball(const WorldModel& world, const Threats& threats, Intention& intention,
                   CommandSlots& slots, Vec2 target, double power, int dash_count) {
  const Vec2 next_self = next_position(world, dash_acceleration(world, power, 0.0));
  const Vec2 next_ball = ball_after(world, 1);
  const double noise =
      kNumbers.dash_noise + world.server().ball_rand * world.ball.velocity.length();
  if (at_feet(world, next_ball, next_self, noise) &&
      threats.cost(next_ball, 1) <= kSkills.threat.dash) {
    return slots.dash(power);
  }

  Lowest<Vec2> best{1e9};
  int best_dashes = 0;
  for (int dashes = std::clamp(dash_count, 1, kMaxDashes); dashes >= 1; --dashes) {
    const Lowest<Vec2> kick = kick_ahead(world, threats, power, dashes);
    if (best.offer(kick.score, kick.value)) best_dashes = dashes;
    if (best.score < kNumbers.enough) break;
  }

  if (best_dashes == 0 || best.score >= kSkills.threat.kickable) {
    return hold_ball(world, slots, true, target);
  }
  if (!kick_to_velocity(world, slots, best.value)) return false;

  set_intention(world, intention, target, power, best_dashes);
  return true;
}

bool continue_turn(const WorldModel& world, Intention& intention, CommandSlots& slots) {
  --intention.turns;
  const double error = (intention.heading - world.self.body).degrees();
  return turn_in_dribble(world, slots, error, intention.dash_power);
}

bool continue_dash(const WorldModel& world, Intention& intention, CommandSlots& slots) {
  const Vec2 next_self = world.self.position + world.self.velocity +
                         dash_acceleration(world, intention.dash_power, 0.0);
  const Vec2 next_ball = ball_after(world, 1);
  const double apart = distance(next_ball, next_self);
  const bool bumps = apart < clear_distance(world);
  const bool leaves_behind = world.self.kickable && intention.dashes <= 1 &&
                             apart > kickable_area(world) - kNumbers.last_dash_margin;
  if (bumps || leaves_behind) return false;

  // Correct a noisy turn by a second one.
  constexpr double kOffCourse = 20.0;
  const double error = (intention.heading - world.self.body).degrees();
  if (std::fabs(error) > kOffCourse) return slots.turn(error);

  --intention.dashes;
  return slots.dash(safe_dash_power(world, intention.dash_power));
}

}  // namespace

bool dribble(const WorldModel& world, Intention& intention, CommandSlots& slots, Vec2 target,
             const DribbleOptions& options) {
  if (!world.self.kickable) return intercept(world, slots, true, target);
  // A ball of unknown velocity is stopped; one that needs no kick for that is at rest as far as
  // is known, and a player who waits for more might wait forever.
  if (!world.ball.velocity_valid() && stop_needs_kick(world)) return stop_ball(world, slots);

  const Vec2 from = self_after(world, 1);
  if (distance(from, target) < options.threshold) return hold_ball(world, slots, true, target);
  AngleDeg heading = AngleDeg::of(target - from);
  if (options.dodge) heading = free_heading(world, heading);

  const Threats threats(world);
  constexpr double kMargin = 12.0;
  const double error = (heading - world.self.body).degrees();
  const double power = safe_dash_power(world, std::clamp(options.dash_power, 0.0, 100.0));
  if (std::fabs(error) > kMargin) return turn_with_ball(world, threats, slots, error, power);

  return run_with_ball(world, threats, intention, slots, target, power, options.dash_count);
}

bool continue_dribble(const WorldModel& world, Intention& intention, CommandSlots& slots) {
  const int left = intention.turns + intention.dashes;
  const bool in_time = world.game.time.cycle == intention.last.cycle + 1;
  const bool arrived = distance(world.self.position, intention.target) < 1.0;
  const bool in_possession =
      !world.kickable_opponent() && !world.kickable_teammate() &&
      world.intercept.first_opponent_steps > world.intercept.best_self_steps();

  const bool in_reach =
      world.ball.position_valid() && world.intercept.best_self_steps() <= left + 2;
  const bool valid = in_time && !arrived && in_possession && in_reach && left > 0;
  const bool turns = intention.turns > 0;
  if (!valid ||
      !(turns ? continue_turn(world, intention, slots) : continue_dash(world, intention, slots))) {
    intention.clear();
    return false;
  }

  intention.last = world.game.time;
  if (intention.turns + intention.dashes == 0) intention.clear();
  return true;
}

}  // namespace cls::player
