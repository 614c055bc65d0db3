// The interface of behaviors: named logic that makes a mock Playmaker's decisions.
#pragma once

#include "proto/playmaker.pb.h"

namespace cls::mock_server {

/// One object serves all agents of a team, from several threads concurrently, and stores nothing
/// between calls: the same State always gets the same reply.
class Behavior {
 public:
  virtual ~Behavior() = default;

  /// Appends a player's actions for this cycle to the empty `actions`.
  virtual void decide(const protos::State& state, protos::PlayerActions& actions) const = 0;

  /// Decide for the coach and for the trainer; no actions by default.
  virtual void decide_as_coach(const protos::State& /*state*/,
                               protos::CoachActions& /*actions*/) const {}
  virtual void decide_as_trainer(const protos::State& /*state*/,
                                 protos::TrainerActions& /*actions*/) const {}
};

}  // namespace cls::mock_server
