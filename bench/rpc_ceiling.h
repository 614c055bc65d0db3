// How many cycles a second gRPC alone allows, with nothing else to do.
#pragma once

#include "proto/playmaker.pb.h"

namespace cls::bench {

enum class Transport { kInProcess, kTcp, kUnixSocket };

struct RpcCeiling {
  double cycles_per_second = 0.0;
  double cpu_us_per_cycle = 0.0;  ///< of the whole process, both ends
};

/// Two teams of eleven ask a Playmaker that answers at once with two actions: 22 calls a cycle in
/// flight together, through the client that agents use, each with `state` as its request. With
/// `threads` 2 each team has a thread of its own and they meet after every cycle, as in a match.
RpcCeiling measure_rpc_ceiling(Transport transport, int threads, const protos::State& state,
                               double seconds);

/// A State of a real match of about the size that is usual in play, 9.7 KB.
protos::State usual_state();

}  // namespace cls::bench
