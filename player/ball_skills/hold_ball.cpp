// Selects a safe ball position around the body.
#include "player/ball_skills/ball_skills.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "player/ball_skills/skill_parameters.h"
#include "player/ball_skills/threats.h"
#include "player/world/candidates.h"
#include "player/world/motion.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

constexpr HoldParameters kNumbers = kSkills.hold;
constexpr int kDirections = 20;
constexpr std::array<double, 3> kShares{0.25, 0.5, 0.7};  ///< of the kickable margin

/// Unit vectors in all directions, starting at the body direction.
const std::array<Vec2, kDirections>& directions() {
  static const auto all = [] {
    std::array<Vec2, kDirections> table;
    for (int i = 0; i < kDirections; ++i) {
      table[i] = soccer::polar_degrees(1.0, 360.0 * i / kDirections);
    }
    return table;
  }();
  return all;
}

/// True if the ball stays kickable and safe without a kick.
bool is_safe_without_kick(const WorldModel& world, const Threats& threats) {
  const Vec2 ball = ball_after(world, 1);
  const double dist = distance(ball, self_after(world, 1));
  const double noise = world.server().ball_rand * world.ball.velocity.length() + kNumbers.noise;
  return world.ball.velocity_valid() && dist < kickable_area(world) - noise &&
         dist > collide_distance(world) + kSkills.dribble.body_gap && inside_pitch(ball) &&
         threats.cost(ball, 1) == 0.0;
}

/// Score of a ball position in the next cycle: kick rate and distance from opponents.
double position_score(const WorldModel& world, const Threats& threats, Vec2 position,
                      Vec2 relative) {
  const double room = std::min(kNumbers.max_room, threats.nearest(position, 1));
  return kNumbers.kick_rate * kick_rate(world, relative, world.self.body) + kNumbers.room * room -
         threats.cost(position, 1);
}

bool kick_to_position(const WorldModel& world, CommandSlots& slots, Vec2 position) {
  return kick_to_velocity(world, slots, position - world.ball.position);
}

bool within_one_kick(const WorldModel& world, Vec2 position) {
  const Vec2 step = position - world.ball.position;
  return (step - world.ball.velocity).length() <= kick_limit(world);
}

/// Kicks the ball to the point in front of the body, where the kick rate is highest.
bool kick_in_front(const WorldModel& world, const Threats& threats, CommandSlots& slots) {
  const double dist =
      collide_distance(world) + kNumbers.front_share * world.self_type().kickable_margin;
  const Vec2 position = self_after(world, 1) + soccer::polar(dist, world.self.body);
  return inside_pitch(position) && !(threats.cost(position, 1) > 0.0) &&
         within_one_kick(world, position) && kick_to_position(world, slots, position);
}

bool kick_to_best_position(const WorldModel& world, const Threats& threats, CommandSlots& slots) {
  const Vec2 next_self = self_after(world, 1);
  const Vec2 body = soccer::polar(1.0, world.self.body);
  Highest<Vec2> best{-1e9};

  for (const Vec2& d : directions()) {
    const Vec2 direction{d.x * body.x - d.y * body.y, d.x * body.y + d.y * body.x};
    for (const double share : kShares) {
      const double dist = collide_distance(world) + share * world.self_type().kickable_margin;
      const Vec2 position = next_self + direction * dist;
      if (!inside_pitch(position) || !within_one_kick(world, position)) continue;
      best.offer(position_score(world, threats, position, direction * dist), position);
    }
  }

  return best.score > -1e9 && kick_to_position(world, slots, best.value);
}

}  // namespace

bool hold_ball(const WorldModel& world, CommandSlots& slots, bool do_turn,
               std::optional<Vec2> face_point) {
  if (!world.self.kickable) return false;
  if (!world.ball.velocity_valid()) {
    stop_ball(world, slots);
    return true;
  }

  const Threats threats(world);
  if (is_safe_without_kick(world, threats)) {
    constexpr double kFacing = 5.0;
    const Vec2 front = do_turn && face_point ? *face_point : Vec2{soccer::kHalfLength - 5.0, 0.0};
    const AngleDeg error = AngleDeg::of(front - self_after(world, 1)) - world.self.body;
    if (error.abs() > kFacing) return slots.turn(error.degrees());
  }

  if (!kick_in_front(world, threats, slots) && !kick_to_best_position(world, threats, slots)) {
    stop_ball(world, slots);
  }
  return true;
}

}  // namespace cls::player
