// Selects the part of the simple team's play by play mode and ball possession: set plays, and field
// players without the ball, are here.
#include "player/simple_team/simple_team.h"

#include <algorithm>

#include "player/simple_team/play.h"

namespace cls::player {
namespace {

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

// Cycles for teammates to arrive before the kick.
constexpr int kWaitCycles = 15;

bool is_taker(const Situation& now) {
  const TeamMode mode = now.mode;
  if (mode == TeamMode::kGoalKick || mode == TeamMode::kGoalieCatch) return now.goalie;
  return !now.goalie && now.is_nearest_to_ball();
}

// 0.5 m behind the ball, so that the kick goes toward the opponent goal.
Vec2 behind_ball(const Situation& now) {
  return now.ball + with_length(now.ball - Vec2{40.0, 0.0}, 0.5);
}

void take_set_play(const Situation& now, ActionList& list) {
  if (!now.kickable) {
    list.go_to(behind_ball(now), 0.3, 80.0);
    list.turn_to_ball();
    list.watch_ball();
    return;
  }

  if (now.set_play_count < kWaitCycles) {
    list.turn_to({40.0, 0.0});
    list.scan();
    return;
  }

  kick_set_play(now, list);
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

void play_set_play(const Situation& now, ActionList& list) {
  if (!now.ball_is_known()) {
    list.search_ball();
    return;
  }

  const bool in_hand = now.mode == TeamMode::kGoalieCatch ||
                       (now.mode == TeamMode::kFreeKick && now.goalie && now.kickable);

  if (now.our_set_play && now.goalie && in_hand) {
    bring_out_caught_ball(now, list);
  } else if (now.our_set_play && is_taker(now)) {
    take_set_play(now, list);
  } else if (now.goalie) {
    keep_goal(now, list);
  } else {
    go_home(now, list);
    list.watch_ball_or_scan(1);
  }
}

void play_simple_team(const Situation& now, ActionList& list) {
  if (now.mode == TeamMode::kPenalty) {
    list.play_penalty();
  } else if (now.mode == TeamMode::kBeforeKickOff) {
    list.places_itself = true;
    list.stand_for_kick_off(kick_off_position(now));
    list.watch_ball_or_scan(0);
  } else if (now.mode != TeamMode::kPlayOn) {
    play_set_play(now, list);
  } else if (now.goalie) {
    keep_goal(now, list);
  } else if (now.kickable) {
    attack(now, list);
  } else {
    play_without_ball(now, list);
  }
}

void hold_positions(const Situation& now, ActionList& list) {
  list.places_itself = true;
  if (now.mode == TeamMode::kBeforeKickOff) list.stand_for_kick_off(kick_off_position(now));
  list.turn_to_ball();
  list.watch_ball();
}

}  // namespace cls::player
