// A brain that leaves everything to the proxy.
#pragma once

#include "mock-server/behaviour.h"

namespace cls::mock_server {

/// Asks for the high-level actions only, as upstream's samples do: goalie, shot and planner for who
/// has the ball, move, set play, penalty. What it is worth is what the proxy's behaviours are
/// worth.
class PlannerTeam : public Behaviour {
 public:
  void decide(const protos::State& state, protos::PlayerActions& actions) const override;
  void decide_as_coach(const protos::State& state, protos::CoachActions& actions) const override;
};

}  // namespace cls::mock_server
