// A 4-3-3 as one table.
#include "mock-server/simple_team/formation.h"

#include <algorithm>
#include <array>

#include "soccer/pitch.h"

namespace cls::mock_server {
namespace {

using soccer::Vec2;

// A place for the ball at the centre mark, how much of the ball's way it follows, and the x range.
struct Place {
  Vec2 base;
  double follow_x;
  double follow_y;
  double least_x;
  double most_x;
  Vec2 kick_off;
};

// clang-format off
constexpr std::array<Place, 11> kPlaces = {{
    {{-50.0,   0.0}, 0.00, 0.00, -50.0, -50.0, {-50.0,   0.0}},
    {{-22.0,  -6.0}, 0.60, 0.25, -44.0,  12.0, {-20.0,  -6.0}},
    {{-22.0,   6.0}, 0.60, 0.25, -44.0,  12.0, {-20.0,   6.0}},
    {{-18.0, -20.0}, 0.65, 0.25, -43.0,  28.0, {-18.0, -20.0}},
    {{-18.0,  20.0}, 0.65, 0.25, -43.0,  28.0, {-18.0,  20.0}},
    {{ -8.0,   0.0}, 0.70, 0.45, -38.0,  30.0, {-11.5,   0.0}},
    {{  0.0, -12.0}, 0.75, 0.35, -34.0,  38.0, { -8.0, -11.0}},
    {{  0.0,  12.0}, 0.75, 0.35, -34.0,  38.0, { -8.0,  11.0}},
    {{ 14.0, -27.0}, 0.75, 0.15, -26.0,  46.0, { -1.5, -24.0}},
    {{ 14.0,  27.0}, 0.75, 0.15, -26.0,  46.0, { -1.5,  24.0}},
    {{ 18.0,   0.0}, 0.75, 0.30, -18.0,  47.0, { -0.8,   0.0}},
}};
// clang-format on

const Place& place_of(int unum) {
  return kPlaces[static_cast<std::size_t>(std::clamp(unum, 1, 11) - 1)];
}

// Our ball, or soon.
bool we_attack(const Situation& now) {
  return std::min(now.own_reach(), now.mates_reach()) <= now.opponents_reach();
}

// Forwards of an attacking team wait on the last line for the ball behind it.
double forward_x(const Situation& now, double formation_x) {
  constexpr double kOnTheLine = 0.3;
  constexpr double kFarthestFromBall = 24.0;
  if (!now.is_play_on() || !we_attack(now)) return formation_x;
  const double line = std::min(now.offside_line() - kOnTheLine, now.ball().x + kFarthestFromBall);
  return std::max(formation_x, std::min(line, 46.0));
}

}  // namespace

Vec2 home_position(const Situation& now) {
  constexpr int kFirstForward = 9;
  constexpr double kOffsideMargin = 0.3;
  constexpr double kTouchLineMargin = 1.5;
  const Place& place = place_of(now.unum());
  const Vec2 ball = now.ball_is_known() ? now.ball() : Vec2{};
  double x = std::clamp(place.base.x + place.follow_x * ball.x, place.least_x, place.most_x);
  if (now.unum() >= kFirstForward) x = forward_x(now, x);
  x = std::min(x, std::max(now.offside_line() - kOffsideMargin, 0.0));
  const double widest = soccer::kHalfWidth - kTouchLineMargin;
  return {x, std::clamp(place.base.y + place.follow_y * ball.y, -widest, widest)};
}

Vec2 kick_off_position(const Situation& now) { return place_of(now.unum()).kick_off; }

}  // namespace cls::mock_server
