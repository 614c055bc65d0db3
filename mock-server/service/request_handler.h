// Replies of the mock Playmaker, independent of the transport.
#pragma once

#include <atomic>
#include <cstdint>

#include "mock-server/behavior/behavior.h"
#include "mock-server/script/expectations.h"
#include "proto/rpc.h"

namespace cls::mock_server {

/// Serves any number of agents from several threads. Register assigns client ids 1, 2, 3, ... in
/// order of arrival.
class RequestHandler {
 public:
  /// Both must outlive the object; `expectations` may be null.
  RequestHandler(const Behavior& behavior, Expectations* expectations)
      : behavior_(behavior), expectations_(expectations) {}

  /// Fills the empty `reply`; the messages are of the RPC's types.
  void handle(proto::Rpc rpc, const google::protobuf::Message& request,
              google::protobuf::Message& reply);

  /// CPU time spent in decisions so far, in nanoseconds.
  std::int64_t decision_nanoseconds() const { return decision_nanoseconds_; }

 private:
  void handle_register(const protos::RegisterRequest& request, protos::RegisterResponse& reply);

  const Behavior& behavior_;
  Expectations* expectations_;
  std::atomic<int> next_client_{1};
  std::atomic<std::int64_t> decision_nanoseconds_{0};
};

}  // namespace cls::mock_server
