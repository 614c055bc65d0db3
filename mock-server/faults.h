// What a mock does wrong on purpose.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "mock-server/script/situation_filter.h"
#include "proto/rpc.h"

namespace cls::mock_server {

/// Shares are probabilities for each decision, drawn from `seed`, agent and cycle: the same match
/// has the same faults. What is about decisions concerns the three rpcs that ask for one.
struct Faults {
  int delay_ms = 0;                     ///< before each decision's answer
  int jitter_ms = 0;                    ///< a drawn time up to this on top
  double drop = 0.0;                    ///< share of decisions that are never answered
  double error = 0.0;                   ///< share answered with `status`
  double garbage = 0.0;                 ///< share answered with bytes that are no message
  double oversize = 0.0;                ///< share answered with more than gRPC's 4 MiB
  std::string status = "UNKNOWN";       ///< name of a gRPC status
  std::optional<int> crash_at_cycle;    ///< dies when asked about this cycle
  std::optional<int> hang_at_cycle;     ///< answers nothing from this cycle on
  std::optional<int> restart_at_cycle;  ///< gone at this cycle, then back without its memory
  int restart_cycles = 10;              ///< how long it is gone
  bool wrong_client_id = false;         ///< Register gives every agent the same identity
  std::vector<proto::Rpc> unimplemented;
  int slow_start_ms = 0;  ///< nothing is answered before

  std::optional<CycleRange> cycles;  ///< all but crash, hang, restart only in these
  std::vector<int> unums;            ///< only for these; empty: all
  std::uint64_t seed = 1;

  bool any() const;
};

/// The object after "faults", keys as the members above, with "only": {"cycle", "unum"}.
base::Result<Faults> parse_faults(const base::JsonValue& json);

/// The number of a gRPC status such as "UNAVAILABLE".
base::Result<int> status_code(std::string_view name);

/// What happens to one call.
struct Fate {
  enum class What {
    kAnswer,
    kNever,
    kError,
    kGarbage,
    kOversize,
    kUnimplemented,
    kCrash,
    kGone,     ///< the process is dead or restarting
    kUnknown,  ///< the caller registered with the process before the restart
  };
  What what = What::kAnswer;
  int delay_ms = 0;
};

/// The fate that the faults alone decide: a function of the request, without memory.
Fate fate_of(const Faults& faults, proto::Rpc rpc, const google::protobuf::Message& request);

}  // namespace cls::mock_server
