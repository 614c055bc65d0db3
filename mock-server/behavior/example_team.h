// The example team of examples/TEAM.md as a behavior of a mock Playmaker.
#pragma once

#include "mock-server/behavior/behavior.h"

namespace cls::mock_server {

/// Attacks with passes, dribbles and shots, and leaves stopped plays, marking and the goal to the
/// proxy's behaviors. Its replies equal those of the example team in every other language.
class ExampleTeam : public Behavior {
 public:
  void decide(const protos::State& state, protos::PlayerActions& actions) const override;
  void decide_as_coach(const protos::State& state, protos::CoachActions& actions) const override;
};

}  // namespace cls::mock_server
