// Listening to a team's conversation with its Playmaker: for records, tests and debug output.
#pragma once

#include <chrono>
#include <memory>

#include "proto/rpc.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// One call and what became of it.
struct RpcCall {
  int agent = 0;
  proto::Rpc rpc = proto::Rpc::kRegister;
  const google::protobuf::Message& request;
  const google::protobuf::Message* reply = nullptr;  ///< null unless `status` is ok
  const RpcStatus& status;
  std::chrono::microseconds latency{0};
};

/// Called from the thread that uses the Playmaker, when a call has ended; those of one cycle come
/// in the order of their answers. What the call points to lives during the call only.
class RpcListener {
 public:
  virtual ~RpcListener() = default;
  virtual void on_call(const RpcCall& call) = 0;
  /// False spares the copies of States: the requests of decisions are then empty messages.
  virtual bool needs_requests() const { return true; }
};

/// The Playmaker `inner` with a listener beside it; both must outlive the returned object.
std::unique_ptr<Playmaker> listen_to(Playmaker& inner, RpcListener& listener);

}  // namespace cls::proxy
