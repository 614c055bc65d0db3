// What a Playmaker's rpcs come to, whatever carries them.
#pragma once

#include <grpcpp/support/status.h>

#include <atomic>
#include <cstdint>

#include "mock-server/behaviour.h"
#include "mock-server/script/expectations.h"
#include "proto/rpc.h"

namespace cls::mock_server {

/// Serves any number of agents from several threads. Register hands out client ids 1, 2, 3, ... in
/// order of arrival.
class GameLogic {
 public:
  /// Both must outlive the object; `expectations` may be null.
  GameLogic(const Behaviour& behaviour, Expectations* expectations)
      : behaviour_(behaviour), expectations_(expectations) {}

  /// Fills the empty `reply`; the messages are those of the rpc.
  void answer(proto::Rpc rpc, const google::protobuf::Message& request,
              google::protobuf::Message& reply);

  /// CPU time spent in decisions so far, in nanoseconds.
  std::int64_t decision_nanoseconds() const { return decision_nanoseconds_; }

 private:
  void introduce(const protos::RegisterRequest& request, protos::RegisterResponse& reply);

  const Behaviour& behaviour_;
  Expectations* expectations_;
  std::atomic<int> next_client_{1};
  std::atomic<std::int64_t> decision_nanoseconds_{0};
};

}  // namespace cls::mock_server
