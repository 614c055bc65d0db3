// A brain that stands where it is and watches the ball.
#pragma once

#include "mock-server/behaviour.h"

namespace cls::mock_server {

/// Goes to its place before kick-off, then only looks. An opponent to measure others against.
class Hold : public Behaviour {
 public:
  void decide(const protos::State& state, protos::PlayerActions& actions) const override;
};

}  // namespace cls::mock_server
