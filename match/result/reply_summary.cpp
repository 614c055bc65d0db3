// Sums, medians and maxima over players.
#include "match/result/reply_summary.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/median.h"

namespace cls::match {

ReplySummary reply_summary(const TeamResult& team) {
  ReplySummary summary;
  std::vector<double> medians;
  for (const PlayerResult& player : team.players) {
    summary.decisions += player.decisions;
    summary.late += player.late;
    summary.missed += player.missed;
    medians.push_back(player.rpc_us.p50);
    summary.rpc_us.p95 = std::max(summary.rpc_us.p95, player.rpc_us.p95);
    summary.rpc_us.p99 = std::max(summary.rpc_us.p99, player.rpc_us.p99);
    summary.rpc_us.max = std::max(summary.rpc_us.max, player.rpc_us.max);
  }
  summary.rpc_us.p50 = base::median(std::move(medians));
  return summary;
}

}  // namespace cls::match
