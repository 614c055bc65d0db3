// Selects the part of the simple team's play by play mode and ball possession.
#include "player/simple_team/simple_team.h"

#include "player/simple_team/formation.h"
#include "player/simple_team/play.h"

namespace cls::player {

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
