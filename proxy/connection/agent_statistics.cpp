// Counting of decisions and commands.
#include "proxy/connection/agent_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/index.h"
#include "proxy/connection/action_names.h"

namespace cls::proxy {

void LatencySamples::add(std::chrono::microseconds latency) {
  constexpr std::int64_t kMax = std::numeric_limits<std::uint32_t>::max();
  samples_.push_back(
      static_cast<std::uint32_t>(std::clamp<std::int64_t>(latency.count(), 0, kMax)));
}

void LatencySamples::add(const LatencySamples& others) {
  samples_.insert(samples_.end(), others.samples_.begin(), others.samples_.end());
}

double LatencySamples::percentile(double share) const {
  if (samples_.empty()) return 0.0;
  const double wanted = std::ceil(share * static_cast<double>(samples_.size()));
  const auto rank = static_cast<std::size_t>(std::max(1.0, wanted)) - 1;
  std::vector<std::uint32_t> sorted = samples_;
  const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(std::min(rank, sorted.size() - 1));
  std::nth_element(sorted.begin(), nth, sorted.end());
  return *nth;
}

std::string_view command_kind_name(std::size_t index) {
  static constexpr std::array<std::string_view, kCommandKinds> names = {
      "turn",        "dash",        "dash",         "turn_neck", "change_focus",
      "kick",        "long_kick",   "catch",        "tackle",    "move",
      "change_view", "synch_see",   "gaussian_see", "say",       "pointto",
      "pointto",     "attentionto", "attentionto",  "ear",       "clang",
      "sense_body",  "score",       "done",         "bye",       "compression"};
  return names.at(index);
}

void AgentStatistics::count(const Reply& reply) {
  ++outcomes[base::index(reply.status.outcome)];
  // Cancelled by the agent itself at the end of a match: not a failure.
  if (reply.status.outcome == RpcOutcome::kCancelled) return;

  ++decisions;
  if (reply.status.ok()) {
    consecutive_missed = 0;
    rpc_us.add(reply.latency);
    return;
  }

  ++missed;
  if (reply.status.outcome == RpcOutcome::kDeadline) ++late;
  max_consecutive_missed = std::max(max_consecutive_missed, ++consecutive_missed);
  last_failure = reply.status;
}

std::map<std::string, std::int64_t> AgentStatistics::commands_by_name() const {
  std::map<std::string, std::int64_t> by_name;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (commands[i] != 0) by_name[std::string(command_kind_name(i))] += commands[i];
  }
  return by_name;
}

std::map<std::string, std::int64_t> AgentStatistics::unimplemented_by_name() const {
  return proxy::unimplemented_by_name(actions);
}

}  // namespace cls::proxy
