// Standing and watching.
#include "mock-server/hold.h"

#include "mock-server/simple_team/action_list.h"
#include "mock-server/simple_team/formation.h"
#include "mock-server/simple_team/situation.h"

namespace cls::mock_server {

void Hold::decide(const protos::State& state, protos::PlayerActions& actions) const {
  const Situation now(state);
  ActionList list(actions);
  actions.set_ignore_preprocess(true);
  if (now.is_before_kick_off()) list.stand_for_kick_off(kick_off_position(now));
  list.turn_to_ball();
  list.watch_ball();
}

}  // namespace cls::mock_server
