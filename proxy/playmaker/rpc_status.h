// How a call ended.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/text/enum_names.h"
#include "proto/rpc.h"

namespace cls::proxy {

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

constexpr auto kRpcOutcomeNames = base::enum_names<RpcOutcome>(
    "ok", "deadline", "unavailable", "unimplemented", "protocol error", "cancelled", "error");

constexpr std::string_view name(RpcOutcome outcome) { return kRpcOutcomeNames.name(outcome); }

/// Outcome, gRPC status code and one line for the user.
struct RpcStatus {
  RpcOutcome outcome = RpcOutcome::kOk;
  int code = 0;
  std::string message;

  bool ok() const { return outcome == RpcOutcome::kOk; }
};

/// The status of a call that ended with this gRPC status; not cancelled by us. Control characters
/// of `error` become spaces: reports have one line.
RpcStatus rpc_status(proto::Rpc rpc, int code, std::string_view error);

}  // namespace cls::proxy
