// Selects the part of the simple team's play by play mode and ball possession.
#include "mock-server/simple_team/simple_team.h"

#include "mock-server/simple_team/action_list.h"
#include "mock-server/simple_team/formation.h"
#include "mock-server/simple_team/play.h"
#include "mock-server/simple_team/situation.h"

namespace cls::mock_server {

void SimpleTeam::decide(const protos::State& state, protos::PlayerActions& actions) const {
  const Situation now(state);
  ActionList list(actions);
  if (now.world().is_penalty_kick_mode()) {
    actions.add_actions()->mutable_helios_penalty();
  } else if (now.is_before_kick_off()) {
    // The proxy would place players by its own formation.
    actions.set_ignore_preprocess(true);
    list.stand_for_kick_off(kick_off_position(now));
    list.watch_ball_or_scan(0);
  } else if (!now.is_play_on()) {
    play_set_play(now, list);
  } else if (now.is_goalie()) {
    keep_goal(now, list);
  } else if (now.can_kick()) {
    attack(now, list);
  } else {
    play_without_ball(now, list);
  }
}

void Hold::decide(const protos::State& state, protos::PlayerActions& actions) const {
  const Situation now(state);
  ActionList list(actions);
  actions.set_ignore_preprocess(true);
  if (now.is_before_kick_off()) list.stand_for_kick_off(kick_off_position(now));
  list.turn_to_ball();
  list.watch_ball();
}

}  // namespace cls::mock_server
