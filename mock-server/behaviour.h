// What a mock Playmaker decides: the seam behind which the bundled brains stand.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "proto/playmaker.pb.h"

namespace cls::mock_server {

/// A brain. One object serves all agents of a team, from several threads at once, and keeps no
/// memory between calls: the same State always gives the same reply.
class Behaviour {
 public:
  virtual ~Behaviour() = default;

  /// Appends the actions of a player for this cycle to the empty `actions`.
  virtual void decide(const protos::State& state, protos::PlayerActions& actions) const = 0;

  /// The same for coach and trainer, who do nothing unless a behaviour says otherwise.
  virtual void decide_as_coach(const protos::State& /*state*/,
                               protos::CoachActions& /*actions*/) const {}
  virtual void decide_as_trainer(const protos::State& /*state*/,
                                 protos::TrainerActions& /*actions*/) const {}
};

/// Names that `make_behaviour` knows.
std::vector<std::string_view> behaviour_names();

/// The behaviour with that name; an empty name is the simple team. "random" may be followed by a
/// seed, "random:7"; "replay:FILE" says again what is in a recording. The error suggests a name.
base::Result<std::unique_ptr<Behaviour>> make_behaviour(std::string_view name);

}  // namespace cls::mock_server
