// What an agent counts while it plays: decisions, latencies, commands, actions it could not do.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "proxy/connection/action_report.h"
#include "proxy/playmaker/playmaker.h"
#include "soccer/commands/player_command.h"

namespace cls::proxy {

/// Latencies in microseconds. All are kept, so percentiles are exact.
class LatencySamples {
 public:
  void add(std::chrono::microseconds latency);
  std::size_t size() const { return samples_.size(); }
  /// The value that `share` (0 to 1) of the samples do not exceed (nearest rank); 0 without any.
  double percentile(double share) const;
  double max() const { return percentile(1.0); }

 private:
  std::vector<std::uint32_t> samples_;
};

constexpr std::size_t kCommandKinds = std::variant_size_v<soccer::PlayerCommand>;

/// The protocol's word for the command at that index of soccer::PlayerCommand, "dash" for both
/// forms of it.
std::string_view command_kind_name(std::size_t index);

/// In real time: a decision begun later than this after it was due is our delay (a loaded machine),
/// not the Playmaker's.
constexpr std::chrono::milliseconds kLateWakeup{10};

struct AgentStatistics {
  std::int64_t decisions = 0;  ///< asked for
  std::int64_t late = 0;       ///< without an answer at the deadline
  std::int64_t missed = 0;     ///< without a usable answer for any reason, late ones included
  std::array<std::int64_t, kRpcOutcomes> outcomes{};  ///< by RpcOutcome
  int missed_in_a_row = 0;                            ///< up to now
  int longest_missed_in_a_row = 0;
  RpcStatus last_failure;  ///< of the latest missed decision; ok when none was missed
  LatencySamples rpc_us;   ///< of the answered ones

  std::int64_t reconnects = 0;      ///< times that a Playmaker that was lost answered again
  std::int64_t planner_asked = 0;   ///< choices left to the Playmaker (GetBestPlannerAction)
  std::int64_t planner_failed = 0;  ///< those without a usable answer

  std::int64_t undecided = 0;      ///< cycles that passed without a decision since the first one
  std::int64_t lost_commands = 0;  ///< body commands that the server did not carry out: too late
  std::int64_t late_wakeups = 0;   ///< decisions begun later than kLateWakeup after they were due
  std::chrono::microseconds longest_wakeup{0};  ///< from being due to being begun

  std::array<std::int64_t, kCommandKinds> commands{};  ///< sent, by index of the variant
  ActionReport actions;                                ///< what became of the Playmaker's wishes

  void count(const Reply& reply);
  void count(const soccer::PlayerCommand& command) { ++commands[command.index()]; }
  /// Commands by protocol word, without zeros.
  std::map<std::string, std::int64_t> commands_by_name() const;
  /// Actions asked for that this proxy has not got, by their name on the wire, without zeros. Parts
  /// of Say are named "say.MEMBER".
  std::map<std::string, std::int64_t> unimplemented_by_name() const;
};

}  // namespace cls::proxy
