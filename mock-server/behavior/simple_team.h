// The simple team as behaviors of a mock Playmaker.
#pragma once

#include "mock-server/behavior/behavior.h"
#include "player/simple_team/situation.h"

namespace cls::mock_server {

/// The parts of a State that the simple team reads.
player::Situation situation_of(const protos::State& state);

/// See play_simple_team().
class SimpleTeam : public Behavior {
 public:
  void decide(const protos::State& state, protos::PlayerActions& actions) const override;
};

/// See hold_positions().
class Hold : public Behavior {
 public:
  void decide(const protos::State& state, protos::PlayerActions& actions) const override;
};

}  // namespace cls::mock_server
