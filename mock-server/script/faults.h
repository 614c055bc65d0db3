// Faults that a mock Playmaker injects.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "mock-server/script/situation_filter.h"
#include "proto/rpc.h"

namespace cls::mock_server {

/// Configuration. Shares are probabilities per decision, drawn from `seed`, agent and cycle: the
/// same match has the same faults. "Decision" stands for the three RPCs that request one.
struct Faults {
  int delay_ms = 0;                        ///< before each decision's reply
  int jitter_ms = 0;                       ///< maximum random additional delay
  double drop = 0.0;                       ///< share of decisions without a reply
  double error = 0.0;                      ///< share that fails with `status`
  double garbage = 0.0;                    ///< share with a reply that does not parse
  double oversize = 0.0;                   ///< share with a reply above gRPC's limit of 4 MiB
  std::string status = "UNKNOWN";          ///< name of a gRPC status
  std::string message = "injected error";  ///< that comes with `status`
  std::optional<int> crash_at_cycle;       ///< crashes at the first decision from this cycle on
  std::optional<int> hang_at_cycle;        ///< no decision gets a reply from this cycle on
  std::optional<int> restart_at_cycle;  ///< unavailable at this cycle, then back without its agents
  int restart_cycles = 10;              ///< duration of the restart
  bool wrong_client_id = false;         ///< Register assigns the same identity to all agents
  std::vector<proto::Rpc> unimplemented;
  bool full_states = false;  ///< TeamPlaymaker without LEAN_STATES
  int slow_start_ms = 0;     ///< no reply before

  std::optional<CycleRange> cycles;  ///< delays and shares apply only in these
  std::vector<int> unums;            ///< delays and shares apply only to these; empty: all
  std::uint64_t seed = 1;

  bool any() const;
};

/// The object of the key "faults": keys as the members above, and "only": {"cycle", "unum"}.
base::Result<Faults> parse_faults(const base::JsonValue& json);

/// The number of a gRPC status such as "UNAVAILABLE".
base::Result<int> status_code(std::string_view name);

/// The fault of one call.
struct Fault {
  enum class What {
    kNone,
    kHang,  ///< no reply
    kError,
    kGarbage,
    kOversize,
    kUnimplemented,
    kCrash,
    kGone,           ///< the process is restarting
    kUnknownClient,  ///< the caller registered before the restart
  };
  What what = What::kNone;
  int delay_ms = 0;
};

/// A pure function of the request; restarts are up to the service.
Fault draw_fault(const Faults& faults, proto::Rpc rpc, const google::protobuf::Message& request);

}  // namespace cls::mock_server
