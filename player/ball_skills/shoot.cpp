// Searches for a shot that no opponent can stop.
#include "player/ball_skills/ball_skills.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/fixed_list.h"
#include "player/ball_skills/skill_parameters.h"
#include "player/world/motion.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

constexpr int kMaxCycles = 30;
constexpr int kMaxCredit = 5;  ///< maximum unseen cycles credited to an opponent

/// A player that may stop a shot. By cycle from now: coasting position, and reach from there when
/// running straight ahead or with a turn (or sideways) first.
struct Stopper {
  Vec2 position;
  Vec2 body;  ///< unit vector; zero if unknown
  bool goalie;
  std::array<Vec2, kMaxCycles + 1> positions;
  std::array<double, kMaxCycles + 1> ahead;
  std::array<double, kMaxCycles + 1> aside;

  bool gets(Vec2 ball, std::size_t cycle) const {
    constexpr double kStraight = 0.9;  // cosine
    const Vec2 way = ball - positions[cycle];
    const double dist = way.length();
    const bool straight = body.is_zero() || dot(way, body) > kStraight * dist;
    return dist < (straight ? ahead[cycle] : aside[cycle]);
  }
};
using Stoppers = base::FixedList<Stopper, 44>;

Stopper stopper_of(const WorldModel& world, const PlayerState& player) {
  const auto& server = world.server();
  const soccer::PlayerType& type = world.type_of(player);
  Stopper stopper{player.position, {}, player.goalie, {}, {}, {}};
  if (player.body_count <= 1) stopper.body = soccer::polar(1.0, player.body);

  const Vec2 velocity = player.known_velocity();
  const double control = player.goalie ? server.catchable_area_l * type.catchable_area_l_stretch
                                       : type.kickable_area(server.ball_size);
  const double push = server.max_dash_power * type.dash_power_rate * type.effort_max;

  double speed = 0.0;
  double run = 0.0;
  double run_before = 0.0;  // one cycle less, for a turn
  const auto dash = [&] {
    run_before = run;
    speed = std::min(speed * type.player_decay + push, type.player_speed_max);
    run += speed;
  };

  for (int unseen = std::min(kMaxCredit, player.pos_count); unseen > 0; --unseen) dash();
  for (std::size_t cycle = 0; cycle <= kMaxCycles; ++cycle) {
    stopper.positions[cycle] =
        coast(player.position, velocity, type.player_decay, static_cast<int>(cycle));
    stopper.ahead[cycle] = control + run;
    stopper.aside[cycle] = control + std::max(run_before, server.side_dash_rate * run);
    dash();
  }

  return stopper;
}

Stoppers stoppers(const WorldModel& world) {
  constexpr int kMaxAge = 20;
  Stoppers list;

  for (const PlayerList* players : {&world.opponents, &world.unknowns}) {
    for (const PlayerState& player : *players) {
      if (player.ghost() || player.pos_count > kMaxAge || player.tackling) continue;
      if (player.position.x < world.ball.position.x - 5.0) continue;
      list.push_back(stopper_of(world, player));
    }
  }

  return list;
}

/// True if no stopper reaches the ball before it crosses the goal line, `line_dist` meters away.
/// `head_start`: cycles before the ball leaves.
bool unstoppable(const WorldModel& world, const Stoppers& list, Vec2 velocity, double line_dist,
                 int head_start) {
  Vec2 ball = world.ball.position;
  double way = 0.0;

  for (int cycle = 1; cycle + head_start <= kMaxCycles; ++cycle) {
    ball += velocity;
    way += velocity.length();
    velocity *= world.server().ball_decay;
    if (way >= line_dist) return true;
    const auto now = static_cast<std::size_t>(cycle + head_start);
    for (const Stopper& stopper : list) {
      if (stopper.gets(ball, now)) return false;
    }
  }

  return false;
}

struct Shot {
  double score = 0.0;
  double speed = 0.0;
  int kicks = 1;
  Vec2 target;
};

double angle_to_goalie(const WorldModel& world, const Stoppers& list, Vec2 target) {
  for (const Stopper& stopper : list) {
    if (!stopper.goalie) continue;
    const AngleDeg goalie = AngleDeg::of(stopper.position - world.ball.position);
    return (AngleDeg::of(target - world.ball.position) - goalie).abs();
  }
  return 180.0;
}

double shot_score(const WorldModel& world, const Stoppers& list, Vec2 target, int kicks) {
  constexpr ShotParameters kNumbers = kSkills.shot;
  const double gap = angle_to_goalie(world, list, target) / kNumbers.goalie_angle;
  double score = kicks == 1 ? kNumbers.one_kick : kNumbers.several_kicks;
  score *= 1.0 - math::exp(-gap * gap / 2.0);

  const double wide = std::max(0.0, std::fabs(target.y) - kNumbers.middle) / kNumbers.wide;
  if (distance(target, world.ball.position) > kNumbers.sure_length) {
    score *= math::exp(-wide * wide / 2.0);
  }
  return score;
}

/// Slowest unstoppable shot at that point; score 0 if none.
Shot shot_at(const WorldModel& world, const Stoppers& list, Vec2 target) {
  const auto& server = world.server();
  const Vec2 way = target - world.ball.position;
  const double dist = way.length();
  const Vec2 direction = way / dist;

  const double one_kick =
      max_speed_along(world.ball.velocity, direction, kick_limit(world), server.ball_speed_max);
  double speed = std::max({(dist + 5.0) * (1.0 - server.ball_decay), one_kick, 1.5});

  for (speed = std::min(speed, server.ball_speed_max);;
       speed = std::min(speed + 0.3, server.ball_speed_max)) {
    const int kicks = speed <= one_kick + 1e-6 ? 1 : 3;
    if (unstoppable(world, list, direction * speed, dist, kicks / 2)) {
      return {shot_score(world, list, target, kicks), speed, kicks, target};
    }
    // Negated comparison: also ends the loop for a NaN speed.
    if (!(speed < server.ball_speed_max)) return {};
  }
}

bool allowed(const WorldModel& world) {
  const PlayMode mode = world.game.mode;
  return world.self.kickable && without_side(mode) != PlayMode::kIndirectFreeKickLeft &&
         !clock_stopped(mode);
}

}  // namespace

bool shoot(const WorldModel& world, CommandSlots& slots, Vec2* aim) {
  constexpr double kRange = 30.0;
  constexpr int kPoints = 25;
  const double dist = distance(world.ball.position, kOpponentGoal);
  if (!allowed(world) || dist > kRange || world.ball.position.x >= soccer::kHalfLength) {
    return false;
  }

  const Stoppers list = stoppers(world);
  const double half = world.server().goal_width / 2.0 - std::min(1.5, 0.6 + 0.042 * dist);
  Shot best;
  for (int i = 0; i < kPoints; ++i) {
    const Vec2 target{soccer::kHalfLength, half * (2.0 * i / (kPoints - 1) - 1.0)};
    const Shot shot = shot_at(world, list, target);
    if (shot.score > best.score) best = shot;
  }

  if (best.score <= 0.0) return false;
  if (aim != nullptr) *aim = best.target;
  if (best.kicks == 1) return kick_one_step(world, slots, best.target, best.speed, false);
  return smart_kick(world, slots, best.target, best.speed, best.speed * 0.99, 3);
}

}  // namespace cls::player
