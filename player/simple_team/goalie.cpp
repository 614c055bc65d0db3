// The goalie's play.
#include "player/simple_team/play.h"

#include <algorithm>
#include <cmath>

#include "soccer/pitch.h"

namespace cls::player {
namespace {

bool in_own_area(Vec2 point) {
  return point.x < -soccer::kHalfLength + soccer::kPenaltyAreaLength - 0.5 &&
         std::fabs(point.y) < soccer::kPenaltyAreaWidth / 2 - 0.5;
}

// On the line from the ball to the goal center; farther out when the ball is farther away.
Vec2 keeping_point(const Situation& now) {
  const Vec2 ball = now.ball + now.ball_velocity * 2.0;
  const double out = std::clamp(distance(ball, kOurGoal) * 0.08, 1.2, 5.0);
  const Vec2 point = kOurGoal + with_length(ball - kOurGoal, out);
  return {std::max(point.x, kOurGoal.x + 0.8), std::clamp(point.y, -6.0, 6.0)};
}

}  // namespace

void keep_goal(const Situation& now, ActionList& list) {
  if (!now.ball_is_known()) {
    list.search_ball();
    return;
  }

  if (in_own_area(now.ball) && now.catch_probability > 0.85F) list.catch_ball();
  if (now.kickable) {
    list.clear_ball();
  } else {
    const bool first = now.own_reach() <= now.opponents_reach() &&
                       now.own_reach() <= now.teammates_reach() && !now.teammate_kicks;
    const Vec2 meeting = now.ball + now.ball_velocity * std::min(now.own_reach(), 8);
    if (first && in_own_area(meeting)) list.intercept({0.0, 0.0});
    if (now.opponent_kicks && in_own_area(now.ball)) list.tackle_towards({0.0, 0.0}, 0.8);

    const Vec2 point = keeping_point(now);
    const bool is_near = distance(now.ball, point) < 30.0;
    list.go_to(point, 0.4, is_near ? 100.0 : 60.0);
    list.turn_to_ball();
  }

  list.watch_ball();
}

void bring_out_caught_ball(const Situation& now, ActionList& list) {
  // Wait until teammates have moved forward, then move to the side with more room and kick.
  constexpr int kWaitCycles = 25;

  if (now.set_play_count < kWaitCycles) {
    list.turn_to({0.0, 0.0});
    list.scan();
    return;
  }

  if (now.set_play_count == kWaitCycles) {
    const double upper = now.nearest_opponent_to({-38.0, -12.0});
    const double lower = now.nearest_opponent_to({-38.0, 12.0});
    list.move_to({-38.0, upper > lower ? -12.0 : 12.0});
    list.scan();
    return;
  }

  kick_set_play(now, list);
}

}  // namespace cls::player
