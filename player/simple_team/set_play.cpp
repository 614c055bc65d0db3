// Kick-offs, kick-ins, corners, goal kicks and free kicks.
#include "player/simple_team/play.h"

namespace cls::player {
namespace {

using soccer::Vec2;

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

}  // namespace cls::player
