// Counters of an agent: decisions, latencies, commands, results of actions.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "player/planner/action_report.h"
#include "proxy/playmaker/playmaker.h"
#include "soccer/commands/player_command.h"

namespace cls::proxy {

/// Latencies in microseconds. All are stored, so percentiles are exact.
class LatencySamples {
 public:
  void add(std::chrono::microseconds latency);
  void add(const LatencySamples& others);
  std::size_t size() const { return samples_.size(); }
  /// The value that `share` (0 to 1) of the samples do not exceed (nearest rank); 0 without any.
  double percentile(double share) const;
  double max() const { return percentile(1.0); }

 private:
  std::vector<std::uint32_t> samples_;
};

constexpr std::size_t kCommandKinds = std::variant_size_v<soccer::PlayerCommand>;

/// Protocol name of the command at that index of soccer::PlayerCommand; "dash" for both forms.
std::string_view command_kind_name(std::size_t index);

/// In real time: a decision that begins later than this after its due time was delayed by this
/// process (busy host), not by the Playmaker.
constexpr std::chrono::milliseconds kLateWakeup{10};

struct AgentStatistics {
  std::int64_t decisions = 0;  ///< requested
  std::int64_t late = 0;       ///< no reply at the deadline
  std::int64_t missed = 0;     ///< no usable reply for any reason, including late
  std::array<std::int64_t, kRpcOutcomes> outcomes{};  ///< by RpcOutcome
  int consecutive_missed = 0;                         ///< so far
  int max_consecutive_missed = 0;
  RpcStatus last_failure;  ///< of the latest missed decision; ok: none
  LatencySamples rpc_us;   ///< of successful decisions

  std::int64_t reconnects = 0;  ///< successful re-registrations after a connection loss or errors
  std::int64_t planner_asked = 0;   ///< calls of GetBestPlannerAction
  std::int64_t planner_failed = 0;  ///< of these, without a usable reply

  std::int64_t undecided = 0;      ///< cycles without a decision since the first decision
  std::int64_t lost_commands = 0;  ///< body commands that arrived too late and were not executed
  std::int64_t late_wakeups = 0;   ///< decisions begun later than kLateWakeup after their due time
  std::chrono::microseconds longest_wakeup{0};  ///< maximum delay from due time to begin

  std::array<std::int64_t, kCommandKinds> commands{};  ///< sent, by index of the variant
  player::ActionReport actions;                        ///< results by kind

  void count(const Reply& reply);
  void count(const soccer::PlayerCommand& command) { ++commands[command.index()]; }
  /// Commands by protocol name, without zeros.
  std::map<std::string, std::int64_t> commands_by_name() const;
  /// Requested actions unknown to this proxy, by field name, without zeros. Members of Say are
  /// named "say.MEMBER".
  std::map<std::string, std::int64_t> unimplemented_by_name() const;
};

}  // namespace cls::proxy
