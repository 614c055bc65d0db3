// Computes goal probabilities from the geometry of shots.
#include "analysis/measures/expected_goals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/play/interception_time.h"
#include "soccer/math.h"
#include "soccer/pitch.h"

namespace cls::analysis {
namespace {

using soccer::Vec2;

constexpr double kReactionCycles = 1.0;

bool in_triangle(Vec2 p, Vec2 a, Vec2 b, Vec2 c) {
  const double ab = soccer::cross(b - a, p - a);
  const double bc = soccer::cross(c - b, p - b);
  const double ca = soccer::cross(a - c, p - c);
  return (ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0);
}

// The goalie's distance from the ball's path minus its reach until the ball crosses.
double goalie_margin(const gamelog::MatchRecord& record, std::size_t entry, const Shot& shot,
                     Vec2 from, double sign) {
  const Vec2 goalie = Vec2(record.players.position[entry]) * sign;
  const double distance =
      soccer::distance(soccer::Segment{from, {soccer::kHalfLength, shot.goal_y}}, goalie);
  const double speed = type_of(record, entry).player_speed_max * kShareOfTopSpeed;
  const double reach = std::max(0.0, shot.cycles - kReactionCycles) * speed;
  return distance - reach - record.server.catchable_area_l;
}

}  // namespace

ShotSituation situation_of(const Flow& flow, const Shot& shot) {
  const gamelog::MatchRecord& record = *flow.record;
  const Touch& touch = flow.touches[shot.touch];
  const double sign = attack_sign(shot.slot);

  const Vec2 from = touch.contact * sign;
  const double half_width = record.server.goal_width / 2;
  const Vec2 top = {soccer::kHalfLength, -half_width};
  const Vec2 bottom = {soccer::kHalfLength, half_width};

  ShotSituation situation = {.distance = shot.distance,
                             .cycles = shot.cycles,
                             .goalie_margin = std::numeric_limits<double>::max()};
  situation.opening = std::fabs(soccer::math::to_radians(soccer::math::normalize_degrees(
      soccer::direction_degrees(bottom - from) - soccer::direction_degrees(top - from))));

  for (const std::size_t other : kTeamSlots[1 - team_of(shot.slot)]) {
    const std::size_t entry = entry_of(touch.frame - 1, other);
    if (!gamelog::is_enabled(record, entry)) continue;
    if (is_goalie(record, entry)) {
      situation.goalie_margin = goalie_margin(record, entry, shot, from, sign);
    } else {
      const Vec2 position = Vec2(record.players.position[entry]) * sign;
      situation.opponents_between += in_triangle(position, from, top, bottom);
    }
  }

  return situation;
}

double goal_probability(const ShotSituation& situation) {
  const double score = 1.2 - 0.12 * situation.distance + 1.0 * situation.opening -
                       0.35 * situation.cycles + (situation.goalie_margin > 0.0 ? 0.6 : 0.0);
  return 1.0 / (1.0 + soccer::math::exp(-score));
}

std::vector<double> expected_goals(const Flow& flow, const std::vector<Shot>& shots) {
  std::vector<double> result;
  for (const Shot& shot : shots) result.push_back(goal_probability(situation_of(flow, shot)));
  return result;
}

}  // namespace cls::analysis
