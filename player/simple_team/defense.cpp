// Field players without the ball: interception, tackle, block, formation.
#include "player/simple_team/play.h"

#include <algorithm>

#include "player/simple_team/formation.h"

namespace cls::player {
namespace {

using soccer::Vec2;

constexpr double kTired = 3200.0;

// Full power near the ball and when behind play in defense; little when tired, since stamina
// below the threshold reduces effort for the rest of the half.
double dash_power(const Situation& now, Vec2 target) {
  const double away = distance(now.position, target);
  if (now.stamina < kTired) return 35.0;
  const bool behind_play = now.position.x > target.x + 3.0 && now.ball.x < 0.0;
  if (behind_play || distance(now.ball, target) < 12.0) return 100.0;
  return std::clamp(40.0 + 3.0 * away, 50.0, 90.0);
}

// Between the ball and the own goal, 2 m from the ball.
Vec2 blocking_point(const Situation& now) {
  const Vec2 ahead = now.ball + now.ball_velocity * 3.0;
  return ahead + with_length(kOurGoal - ahead, 2.0);
}

}  // namespace

void go_home(const Situation& now, ActionList& list) {
  const Vec2 home = home_position(now);
  const double within = std::max(0.8, 0.08 * distance(now.ball, home));
  list.go_to(home, within, dash_power(now, home));
  list.turn_to_ball();
}

void play_without_ball(const Situation& now, ActionList& list) {
  if (!now.ball_is_known()) {
    list.search_ball();
    return;
  }

  const bool can_win_ball = now.opponent_kicks && !now.teammate_kicks;
  if (can_win_ball) list.tackle_towards(kTheirGoal, 0.75);

  const bool teammates_slower = now.own_reach() <= now.teammates_reach() && !now.teammate_kicks;
  if (teammates_slower && now.own_reach() < kNeverReached) {
    if (now.opponent_kicks) list.go_to(blocking_point(now), 0.5, 100.0);
    list.intercept(kTheirGoal);
    list.watch_ball_or_scan(0);
    return;
  }

  go_home(now, list);
  list.watch_ball_or_scan(now.opponents_reach() < 5 ? 1 : 2);
}

}  // namespace cls::player
