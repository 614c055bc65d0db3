// A team's view of its Playmaker: RPCs as data, calls in flight together.
#pragma once

#include <google/protobuf/message.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "proto/playmaker.pb.h"
#include "proto/rpc.h"

namespace cls::proxy {

/// Agents of a team are numbered by the uniform number of their Register call.
constexpr int kCoachNumber = 12;
constexpr int kTrainerNumber = 13;
constexpr int kAgentNumbers = 14;  ///< 1 to 13 in use; size of arrays by agent number

/// Timeout of a call. kNoTimeout waits as long as the connection lives.
using RpcTimeout = std::chrono::milliseconds;
constexpr RpcTimeout kNoTimeout = RpcTimeout::max();

/// Result of a call.
enum class RpcOutcome : std::uint8_t {
  kOk,
  kDeadline,       ///< no reply before the deadline
  kUnavailable,    ///< unreachable, or the connection broke
  kUnimplemented,  ///< the Playmaker implements an older interface without this RPC
  kProtocolError,  ///< the reply does not parse
  kCancelled,      ///< cancel() was called
  kError,          ///< the Playmaker replied with an error status
};
constexpr int kRpcOutcomes = 7;

constexpr std::string_view name(RpcOutcome outcome) {
  constexpr std::array<std::string_view, kRpcOutcomes> kNames = {
      "ok", "deadline", "unavailable", "unimplemented", "protocol error", "cancelled", "error"};
  return kNames.at(static_cast<std::size_t>(outcome));
}

/// Outcome, gRPC status code and one line for the user.
struct RpcStatus {
  RpcOutcome outcome = RpcOutcome::kOk;
  int code = 0;
  std::string message;

  bool ok() const { return outcome == RpcOutcome::kOk; }
};

/// The reply to one call.
struct Reply {
  int agent = 0;
  proto::Rpc rpc = proto::Rpc::kRegister;
  RpcStatus status;
  /// Of the RPC's reply type; null unless `status` is ok. Owned by the Playmaker, valid until the
  /// next call of this agent.
  const google::protobuf::Message* message = nullptr;
  std::chrono::microseconds latency{0};  ///< from begin() or call() until the reply arrived

  /// The message as `T`; null when the call failed or the RPC replies with another type.
  template <typename T>
  const T* as() const {
    const bool is_t = message != nullptr && message->GetDescriptor() == T::descriptor();
    return is_t ? static_cast<const T*>(message) : nullptr;
  }
};

/// Client of one Playmaker for all agents of a team. Used by one thread; only cancel() may be
/// called from others.
class Playmaker {
 public:
  virtual ~Playmaker() = default;

  /// Starts a call; at most one per agent may be outstanding. `request` is serialized before the
  /// function returns. All outstanding calls are in flight together. With `wait_for_ready`, waits
  /// for the Playmaker to come up, up to `timeout`.
  virtual void begin(int agent, proto::Rpc rpc, const google::protobuf::Message& request,
                     RpcTimeout timeout, bool wait_for_ready = false) = 0;

  /// Makes a call and blocks until its reply; no other call may be outstanding. Register waits for
  /// the Playmaker to come up, up to `timeout`.
  virtual Reply call(int agent, proto::Rpc rpc, const google::protobuf::Message& request,
                     RpcTimeout timeout) = 0;

  /// True once after the connection over which this agent received replies was lost. A restarted
  /// Playmaker, which does not know the agent, may listen at its other end now.
  virtual bool take_connection_loss(int agent) = 0;

  /// Waits for any outstanding call and returns its reply; nullopt when none is outstanding.
  /// Replies arrive in any order.
  virtual std::optional<Reply> next_reply() = 0;

  /// As next_reply(), but also nullopt when no reply arrives within `timeout`.
  virtual std::optional<Reply> next_reply_within(std::chrono::microseconds timeout) = 0;

  /// Cancels calls in flight and fails later ones with kCancelled, except SendByeCommand. Thread
  /// safe.
  virtual void cancel() = 0;
};

}  // namespace cls::proxy
