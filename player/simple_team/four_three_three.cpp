// The 4-3-3 as one table.
#include "player/simple_team/play.h"

#include <algorithm>
#include <array>

#include "base/index.h"
#include "soccer/pitch.h"

namespace cls::player {
namespace {

// Position with the ball at the center mark, share of ball movement followed, and x range.
struct HomePosition {
  Vec2 base;
  double follow_x;
  double follow_y;
  double min_x;
  double max_x;
  Vec2 kick_off;
};

// clang-format off
constexpr std::array<HomePosition, 11> kHomePositions = {{
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

const HomePosition& entry_of(int unum) {
  return kHomePositions[base::index(std::clamp(unum, 1, 11) - 1)];
}

// The team has the ball or reaches it first.
bool we_attack(const Situation& now) {
  return std::min(now.own_reach(), now.teammates_reach()) <= now.opponents_reach();
}

// Forwards of the attacking team wait on the offside line for a through pass.
double forward_x(const Situation& now, double formation_x) {
  constexpr double kLineMargin = 0.3;
  constexpr double kMaxFromBall = 24.0;
  if (now.mode != TeamMode::kPlayOn || !we_attack(now)) return formation_x;
  const double line = std::min(now.offside_line - kLineMargin, now.ball.x + kMaxFromBall);
  return std::max(formation_x, std::min(line, 46.0));
}

}  // namespace

Vec2 home_position(const Situation& now) {
  constexpr int kFirstForward = 9;
  constexpr double kOffsideMargin = 0.3;
  constexpr double kTouchLineMargin = 1.5;

  const HomePosition& home = entry_of(now.unum);
  const Vec2 ball = now.ball_is_known() ? now.ball : Vec2{};

  double x = std::clamp(home.base.x + home.follow_x * ball.x, home.min_x, home.max_x);
  if (now.unum >= kFirstForward) x = forward_x(now, x);
  x = std::min(x, std::max(now.offside_line - kOffsideMargin, 0.0));

  const double widest = soccer::kHalfWidth - kTouchLineMargin;
  return {x, std::clamp(home.base.y + home.follow_y * ball.y, -widest, widest)};
}

Vec2 kick_off_position(const Situation& now) { return entry_of(now.unum).kick_off; }

}  // namespace cls::player
