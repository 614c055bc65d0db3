// A brain that asks for anything at all: what a proxy and a server must survive.
#pragma once

#include <cstdint>

#include "mock-server/behaviour.h"

namespace cls::mock_server {

/// One to four actions a cycle, any of the wire with any arguments, drawn from seed, number and
/// cycle: the same State always gets the same reply.
class RandomBrain : public Behaviour {
 public:
  explicit RandomBrain(std::uint64_t seed) : seed_(seed) {}

  void decide(const protos::State& state, protos::PlayerActions& actions) const override;
  void decide_as_coach(const protos::State& state, protos::CoachActions& actions) const override;
  void decide_as_trainer(const protos::State& state,
                         protos::TrainerActions& actions) const override;

 private:
  std::uint64_t seed_;
};

}  // namespace cls::mock_server
