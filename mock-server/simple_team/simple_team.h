// The bundled brain: plain soccer out of the wire's actions.
#pragma once

#include "mock-server/behaviour.h"

namespace cls::mock_server {

/// A 4-3-3 that passes, dribbles, shoots and defends well enough to make an ordinary match of two
/// of its kind. A pure function of the State.
class SimpleTeam : public Behaviour {
 public:
  void decide(const protos::State& state, protos::PlayerActions& actions) const override;
};

}  // namespace cls::mock_server
