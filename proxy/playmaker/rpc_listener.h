// Observes a team's calls to its Playmaker: for recordings, tests and debug output.
#pragma once

#include <chrono>
#include <memory>

#include "proto/rpc.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// A completed call.
struct RpcCall {
  int agent = 0;
  proto::Rpc rpc = proto::Rpc::kRegister;
  const google::protobuf::Message& request;
  const google::protobuf::Message* reply = nullptr;  ///< null unless `status` is ok
  const RpcStatus& status;
  std::chrono::microseconds latency{0};
};

/// Called on the thread that uses the Playmaker when a call has completed; the calls of one cycle
/// in the order of their replies. The pointers are valid during on_call() only.
class RpcListener {
 public:
  virtual ~RpcListener() = default;
  virtual void on_call(const RpcCall& call) = 0;
  /// False saves copying each request of begin(): RpcCall::request is then an empty message.
  virtual bool needs_requests() const { return true; }
};

/// Forwards all calls to `inner` and reports them to `listener`; both must outlive the returned
/// object.
std::unique_ptr<Playmaker> listen_to(Playmaker& inner, RpcListener& listener);

}  // namespace cls::proxy
