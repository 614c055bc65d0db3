// Predicts opponents near the ball.
#include "player/ball_skills/threats.h"

#include <algorithm>
#include <cmath>

#include "player/ball_skills/skill_parameters.h"
#include "player/world/motion.h"

namespace cls::player {

Threats::Threats(const WorldModel& world)
    : tackle_dist_(world.server().tackle_dist), tackle_width_(world.server().tackle_width) {
  constexpr double kNear = 10.0;
  constexpr int kMaxAge = 10;

  for (const PlayerState& player : world.opponents) {
    if (player.ghost() || player.pos_count > kMaxAge || player.dist_from_self > kNear) continue;
    const soccer::PlayerType& type = world.type_of(player);
    Opponent opponent{};
    const Vec2 velocity = player.known_velocity();
    const double push = world.server().max_dash_power * type.dash_power_rate * type.effort_max;

    double speed = 0.0;
    // Unseen motion: up to two dashes.
    double reach = 0.3 * std::min(player.pos_count, 2);
    for (int cycle = 0; cycle < kCycles; ++cycle) {
      opponent.positions[cycle] = coast(player.position, velocity, type.player_decay, cycle);
      opponent.reach[cycle] = reach;
      speed = std::min(speed * type.player_decay + push, type.player_speed_max);
      reach += speed;
    }

    opponent.kickable_area = type.kickable_area(world.server().ball_size);
    if (player.body_count <= 1) opponent.body = soccer::polar(1.0, player.body);
    opponent.tackling = player.tackling;
    near_.push_back(opponent);
  }
}

bool Threats::can_tackle(const Opponent& opponent, Vec2 relative) const {
  // Tackles beyond this fraction of the tackle range rarely succeed.
  constexpr double kSerious = 0.8;
  if (opponent.tackling) return false;
  if (opponent.body.is_zero()) return relative.length() < tackle_width_;
  const double ahead = dot(relative, opponent.body);
  return ahead > 0.0 && ahead < tackle_dist_ * kSerious &&
         std::fabs(cross(opponent.body, relative)) < tackle_width_ * kSerious;
}

double Threats::cost(Vec2 ball, int cycles) const {
  double worst = 0.0;
  for (const Opponent& opponent : near_) {
    const Vec2 relative = ball - opponent.positions[cycles];
    const double dist = relative.length();
    if (dist < opponent.kickable_area) {
      worst = std::max(worst, opponent.tackling ? 0.0 : kSkills.threat.kickable);
    } else if (can_tackle(opponent, relative)) {
      worst = std::max(worst, kSkills.threat.tackle);
    } else if (!opponent.tackling && dist < opponent.kickable_area + opponent.reach[cycles]) {
      worst = std::max(worst, kSkills.threat.dash);
    }
  }

  return worst;
}

double Threats::nearest(Vec2 ball, int cycles) const {
  double nearest = 1000.0;
  for (const Opponent& opponent : near_) {
    nearest = std::min(nearest, distance(ball, opponent.positions[cycles]));
  }
  return nearest;
}

}  // namespace cls::player
