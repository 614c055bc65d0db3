// Intersects the line of sight with the border lines.
#include "simulator/senses/sight_lines.h"

#include <array>
#include <cmath>
#include <optional>

#include "soccer/math.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;
using soccer::kHalfLength;
using soccer::kHalfWidth;
using soccer::PitchLine;

/// A border line seen from a player.
struct Border {
  PitchLine line;
  bool vertical;
  double offset;  ///< signed, from the player to the line
  double normal;  ///< direction of the normal that points away from the player's side
};

std::array<Border, soccer::kPitchLineCount> borders_from(Vec2 p) {
  constexpr double kRightAngle = math::kPi / 2.0;
  return {
      {{PitchLine::kLeft, true, -kHalfLength - p.x, p.x < -kHalfLength ? 0.0 : math::kPi},
       {PitchLine::kRight, true, kHalfLength - p.x, p.x > kHalfLength ? math::kPi : 0.0},
       {PitchLine::kTop, false, -kHalfWidth - p.y, p.y < -kHalfWidth ? kRightAngle : -kRightAngle},
       {PitchLine::kBottom, false, kHalfWidth - p.y,
        p.y > kHalfWidth ? -kRightAngle : kRightAngle}}};
}

std::optional<SightLine> intersect(const Player& player, const Border& border) {
  constexpr double kRightAngle = math::kPi / 2.0;
  const double angle = math::normalize_radians(border.normal - player.body - player.neck);
  if (std::fabs(angle) >= kRightAngle) return std::nullopt;
  const double along = border.offset * math::tan(angle);
  const Vec2 p = player.position;
  const bool on_pitch = border.vertical ? std::fabs(p.y - along) <= kHalfWidth
                                        : std::fabs(p.x + along) <= kHalfLength;
  if (!on_pitch) return std::nullopt;
  return SightLine{border.line, std::fabs(border.offset / math::cos(angle)),
                   angle > 0.0 ? angle - kRightAngle : angle + kRightAngle};
}

}  // namespace

SightLines lines_in_sight(const Player& player) {
  const Vec2 p = player.position;
  const bool inside = std::fabs(p.x) < kHalfLength && std::fabs(p.y) < kHalfWidth;
  const std::size_t max_lines = inside ? 1 : 2;
  SightLines lines;
  for (const Border& border : borders_from(p)) {
    if (lines.size() == max_lines) break;
    if (const auto line = intersect(player, border)) lines.push_back(*line);
  }
  return lines;
}

}  // namespace cls::simulator
