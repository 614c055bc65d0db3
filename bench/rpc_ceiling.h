// Upper bound of cycles per second that gRPC alone allows.
#pragma once

#include "proto/playmaker.pb.h"

namespace cls::bench {

enum class Transport { kInProcess, kTcp, kUnixSocket };

struct RpcCeiling {
  double cycles_per_second = 0.0;
  double cpu_us_per_cycle = 0.0;  ///< of the whole process, client and server
};

/// How a team asks: a call per agent, or one call with whole or lean States (docs/wire.md).
enum class Asking { kEachAgent, kTeam, kTeamLean };

/// Two teams of eleven call a Playmaker that immediately replies with two actions, through the
/// client of the agents; the State of each agent is `state`. With `threads` 2 each team has its own
/// thread and both synchronize after every cycle, as in a match.
RpcCeiling measure_rpc_ceiling(Transport transport, int threads, Asking asking,
                               const protos::State& state, double seconds);

/// A recorded State of typical size, 9.7 KB.
protos::State typical_state();

}  // namespace cls::bench
