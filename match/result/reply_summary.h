// How the Playmaker of a side replied in a match.
#pragma once

#include <cstdint>

#include "match/result/match_result.h"

namespace cls::match {

/// Sums over the players of a side.
struct ReplySummary {
  std::int64_t decisions = 0;
  std::int64_t late = 0;
  std::int64_t missed = 0;
  RpcLatency rpc_us;  ///< p50 of the median player, the other figures of the slowest one
};

ReplySummary reply_summary(const TeamResult& team);

}  // namespace cls::match
