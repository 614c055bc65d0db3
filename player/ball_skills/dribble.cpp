// Dribbling: turn, dash, or kick the ball ahead.
#include "player/ball_skills/dribble.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "player/ball_skills/hold_ball.h"
#include "player/ball_skills/kick.h"
#include "player/ball_skills/threats.h"
#include "player/movement/intercept.h"
#include "player/world/leg_dash.h"
#include "player/world/motion.h"
#include "soccer/pitch.h"

namespace cls::player {
namespace {

using soccer::AngleDeg;
using soccer::Vec2;

constexpr int kMaxDashes = 10;
constexpr double kBodyGap = 0.05;  ///< minimum distance between ball and body, meters

bool inside_pitch(Vec2 point) {
  constexpr double kInset = 0.3;
  return std::fabs(point.x) < soccer::kHalfLength - kInset &&
         std::fabs(point.y) < soccer::kHalfWidth - kInset;
}

/// True if the ball is kickable for a player at `self`, with a noise margin, and does not collide
/// with it.
bool at_feet(const WorldModel& world, Vec2 ball, Vec2 self, double noise) {
  const double dist = distance(ball, self);
  return dist < kickable_area(world) - noise && dist > collide_distance(world) + kBodyGap;
}

/// Own positions by cycle: kick in this cycle, dashes in the next ones.
std::array<Vec2, kMaxDashes + 2> positions_while_dashing(const WorldModel& world, double power,
                                                         int dashes) {
  std::array<Vec2, kMaxDashes + 2> positions;
  Vec2 position = world.self.position;
  Vec2 velocity = world.self.velocity;
  const Vec2 push = dash_acceleration(world, power, 0.0);

  positions[0] = position;
  for (int cycle = 1; cycle <= dashes + 1; ++cycle) {
    if (cycle > 1) velocity = speed_limited(velocity + push, world.self_type().player_speed_max);
    position += velocity;
    velocity *= world.self_type().player_decay;
    positions[static_cast<std::size_t>(cycle)] = position;
  }

  return positions;
}

struct KickAhead {
  double cost = 1e9;
  Vec2 velocity;
};

/// Best kick after which the agent reaches the ball with `dashes` dashes.
KickAhead kick_ahead(const WorldModel& world, const Threats& threats, double power, int dashes) {
  static constexpr std::array<double, 7> kOffsets{0.0, 25.0, -25.0, 50.0, -50.0, 80.0, -80.0};
  const double decay = world.server().ball_decay;
  const auto self = positions_while_dashing(world, power, dashes);
  const Vec2 ball = world.ball.position;
  const int cycles = dashes + 1;
  const double radius = collide_distance(world) + 0.45 * world.self_type().kickable_margin;

  KickAhead best;
  for (const double offset : kOffsets) {
    const Vec2 end = self[cycles] + soccer::polar(radius, world.self.body + offset);
    const Vec2 way = end - ball;
    const double length = way.length();
    if (length < 1e-6 || !inside_pitch(end)) continue;
    const Vec2 velocity = way * (first_speed(length, cycles, decay) / length);
    if ((velocity - world.ball.velocity).length() > kick_limit(world)) continue;

    double cost = 0.2 * std::fabs(offset);
    bool clean = velocity.length() <= world.server().ball_speed_max;
    for (int n = 1; n < cycles && clean; ++n) {
      const Vec2 there = coast(ball, velocity, decay, n);
      clean = distance(there, self[n]) > collide_distance(world) + kBodyGap;
      if (n <= 3) cost += threats.cost(there, n);
    }

    cost += threats.cost(end, std::min(cycles, 3));
    if (clean && cost < best.cost) best = {cost, velocity};
  }

  return best;
}

/// Kicks the ball to a safe point around the body for the time of turning toward `heading`.
bool kick_for_turn(const WorldModel& world, const Threats& threats, CommandSlots& slots,
                   AngleDeg heading, int turns) {
  const double decay = world.server().ball_decay;
  const int cycles = turns + 1;
  double best_cost = 1e9;
  Vec2 best;

  for (double offset = 0.0; offset < 360.0; offset += 20.0) {
    for (const double share : {0.25, 0.5}) {
      const double radius = collide_distance(world) + share * world.self_type().kickable_margin;
      const Vec2 end = self_after(world, cycles) + soccer::polar(radius, heading + offset);
      const Vec2 way = end - world.ball.position;
      const double length = way.length();
      const Vec2 velocity =
          length < 1e-6 ? Vec2{} : way * (first_speed(length, cycles, decay) / length);
      if ((velocity - world.ball.velocity).length() > kick_limit(world)) continue;

      const Vec2 next = world.ball.position + velocity;
      if (distance(next, self_after(world, 1)) < collide_distance(world) + kBodyGap) continue;
      const double cost = threats.cost(next, 1) + threats.cost(end, std::min(cycles, 3)) +
                          0.3 * AngleDeg(offset).abs() -
                          20.0 * std::min(4.0, threats.nearest(end, std::min(cycles, 3)));
      if (inside_pitch(end) && cost < best_cost) {
        best_cost = cost;
        best = velocity;
      }
    }
  }

  return best_cost < 1e9 && kick_to_velocity(world, slots, best);
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
  const double noise = 0.1 + world.server().ball_rand * world.ball.velocity.length();
  const auto turn = useful_leg_turn(world, error, power, true);
  if (turn && at_feet(world, ball, next_position(world, turn->acceleration), noise + 0.05) &&
      threats.cost(ball, 1) <= 150.0) {
    return slots.dash(turn->legs);
  }
  if (at_feet(world, ball, self_after(world, 1), noise) && threats.cost(ball, 1) <= 150.0) {
    return slots.turn(error);
  }

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
  intention.clear();
  intention.kind = Intention::Kind::kDribble;
  intention.target = target;
  intention.heading = world.self.body;
  intention.dash_power = power;
  intention.dashes = dashes;
  intention.last = world.game.time;
}

/// One dash if the ball stays kickable, otherwise a kick followed by up to `dash_count` dashes.
bool run_with_ball(const WorldModel& world, const Threats& threats, Intention& intention,
                   CommandSlots& slots, Vec2 target, double power, int dash_count) {
  const Vec2 next_self = next_position(world, dash_acceleration(world, power, 0.0));
  const Vec2 next_ball = ball_after(world, 1);
  const double noise = 0.15 + world.server().ball_rand * world.ball.velocity.length();
  if (at_feet(world, next_ball, next_self, noise) && threats.cost(next_ball, 1) <= 150.0) {
    return slots.dash(power);
  }

  KickAhead best;
  int best_dashes = 0;
  for (int dashes = std::clamp(dash_count, 1, kMaxDashes); dashes >= 1; --dashes) {
    const KickAhead kick = kick_ahead(world, threats, power, dashes);
    if (kick.cost < best.cost) {
      best = kick;
      best_dashes = dashes;
    }
    if (best.cost < 100.0) break;
  }

  if (best_dashes == 0 || best.cost >= 600.0) return hold_ball(world, slots, true, target);
  if (!kick_to_velocity(world, slots, best.velocity)) return false;

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
  const bool bumps = distance(next_ball, next_self) < collide_distance(world) + kBodyGap;
  const bool leaves_behind = world.self.kickable &&
                             distance(next_ball, next_self) > kickable_area(world) - 0.1 &&
                             intention.dashes <= 1;
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
  if (!in_time || arrived || !in_possession || !in_reach || left <= 0) {
    intention.clear();
    return false;
  }

  const bool continued = intention.turns > 0 ? continue_turn(world, intention, slots)
                                             : continue_dash(world, intention, slots);
  if (!continued) {
    intention.clear();
    return false;
  }

  intention.last = world.game.time;
  if (intention.turns + intention.dashes == 0) intention.clear();
  return true;
}

}  // namespace cls::player
