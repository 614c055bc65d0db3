// Calls that a Playmaker answered with an error, and how to repeat the first of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "proto/rpc.h"
#include "proto/rpc_recording.pb.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// A decision or a planner's choice that the Playmaker answered with an error.
struct PlaymakerError {
  int agent = 0;
  int cycle = 0;  ///< game time
  proto::Rpc rpc = proto::Rpc::kGetPlayerActions;
  std::string status;   ///< "UNKNOWN"; "unreadable reply" for bytes that are not a message
  std::string message;  ///< of the Playmaker, one line
  /// The agent's handshake and the call itself: a recording to be sent again. `side` is not set.
  std::vector<recording::RecordedCall> calls;

  /// "player 9: GetPlayerActions failed at cycle 50: UNKNOWN: Exception calling application: ...",
  /// with a hint where the message is known to puzzle.
  std::string describe() const;
};

struct PlaymakerErrors {
  std::int64_t count = 0;
  std::optional<PlaymakerError> first;  ///< earliest cycle, then lowest agent number
};

/// True for an error status of the Playmaker's own and for a reply that does not parse; false for
/// a deadline, a lost connection, a cancelled or an unimplemented RPC.
bool is_error(const RpcStatus& status);

/// "player 9", "the coach", "the trainer".
std::string agent_name(int agent);

/// The first error without `calls`. `reply` has failed.
PlaymakerError describe_error(const Reply& reply, int cycle);

/// A call as a recording has it. `step` as in rpc_recording.proto.
recording::RecordedCall record_call(int agent, proto::Rpc rpc, int step,
                                    const google::protobuf::Message& request);

}  // namespace cls::proxy
