// Replies of the mock to calls of single agents, with injected faults.
#pragma once

#include <grpcpp/grpcpp.h>

#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "mock-server/script/faults.h"
#include "mock-server/service/request_handler.h"

namespace cls::mock_server {

/// How the mock ends a call.
struct Response {
  grpc::Status status;
  bool hangs = false;  ///< no reply until the client cancels
  int delay_ms = 0;
  std::optional<std::string> bytes;  ///< instead of the message
};

/// Serves any number of agents from several threads. Crash and restart are simulated (calls fail as
/// they would, a restarted Playmaker knows no agent) unless `die` is given.
class Responder {
 public:
  /// `handler` must outlive the object. `die` is called when a crash is due; it should not return.
  Responder(RequestHandler& handler, Faults faults, std::function<void()> die);

  /// Fills the empty `message`, of the RPC's reply type, unless the call fails.
  Response respond(proto::Rpc rpc, const google::protobuf::Message& request,
                   google::protobuf::Message& message);

  /// True when a fault says that RPCs are not implemented: a Playmaker of an older interface.
  bool older_interface() const { return !faults_.unimplemented.empty(); }
  /// False when a fault says that TeamPlaymaker knows STATES only.
  bool lean_states() const { return !faults_.full_states; }

 private:
  Fault choose_fault(proto::Rpc rpc, const google::protobuf::Message& request);
  void alter_identity(protos::RegisterResponse& identity);

  RequestHandler& handler_;
  Faults faults_;
  bool faulty_;
  std::function<void()> die_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();

  std::mutex mutex_;
  bool dead_ = false;
  bool restarting_;        ///< the restart has begun or is complete
  std::set<int> clients_;  ///< registered since the restart began
};

}  // namespace cls::mock_server
