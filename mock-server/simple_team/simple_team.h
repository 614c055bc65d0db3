// The bundled team, and a team that only holds its positions.
#pragma once

#include "mock-server/behavior/behavior.h"

namespace cls::mock_server {

/// A 4-3-3 that passes, dribbles, shoots and defends well enough for an ordinary match against
/// itself. A pure function of the State.
class SimpleTeam : public Behavior {
 public:
  void decide(const protos::State& state, protos::PlayerActions& actions) const override;
};

/// Moves to its kick-off positions, then only turns to the ball: a baseline opponent.
class Hold : public Behavior {
 public:
  void decide(const protos::State& state, protos::PlayerActions& actions) const override;
};

}  // namespace cls::mock_server
