// A soccer server over UDP: a process that the match starts, or one that runs already.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/results/match_summary.h"
#include "gamelog/record/match_record.h"
#include "match/server/game_log_follower.h"
#include "match/server/match_plan.h"
#include "match/server/match_server.h"
#include "match/server/server_relay.h"
#include "process/connection_trap.h"
#include "process/namespaces.h"
#include "process/process_host.h"
#include "process/socket_owner.h"

namespace cls::match {

/// Followed by its output lines and its game log, where cls started it.
class ExternalServer : public Server {
 public:
  /// `options` and `host` must outlive the server. `host` may be null for a server that runs
  /// already.
  ExternalServer(const MatchOptions& options, MatchPlan plan, process::ProcessHost* host,
                 const std::filesystem::path& folder);

  /// The name of a side whose agents are those of cls: no program of the other side may have it.
  void reserve_name(soccer::Side side, std::string_view name) { names_.claim(side, name); }
  /// Lets the programs in these namespaces, which have a network of their own, take part for `side`
  /// and do nothing else. The error says what cannot be opened.
  base::Result<void> open_relay(soccer::Side side,
                                std::shared_ptr<const process::Namespaces> namespaces);

  /// Waits for a poll interval and reads what is new.
  void poll();
  /// The time for which a healthy match may show no progress.
  std::chrono::milliseconds quiet_time() const;

  /// The state in which the match leaves the server.
  enum class FinalState {
    kOver,     ///< the match is over: the server exits
    kHeld,     ///< the clients hold it at the cycle limit
    kRunning,  ///< it would continue
  };
  /// Shuts the server down if cls started it. A signal shortens the wait for its exit.
  void finish(FinalState state, const std::atomic<int>& signal);

  std::optional<MatchEnd> start(const std::function<bool()>& keep_waiting) override;
  std::string waiting_for() const override;
  std::string monitor_address() const override;
  const process::Child* child() const override { return child_.get(); }
  void wait_for_clients() override;
  ServerStatus status() const override { return output_.status(); }
  std::vector<std::string> take_warnings() override;
  bool binds_clients() const override;
  bool keeps_places(soccer::Side side) const override;
  std::optional<Intruder> intruder() override;
  SourceProgress progress() const override;
  bool finished() const override;
  std::optional<MatchEnd> failure(bool playing) override;
  std::vector<ProcessResult> wait_gone() override;
  void add_result(MatchResult& result, const std::vector<AgentProgress>& agents) const override;

 private:
  base::Result<void> trap_connections();
  bool has_open_port() const;
  int server_process() const;
  void look_for_intruder();
  MatchEnd refused(std::string message) const;
  void read_log(MatchResult& result, const std::vector<AgentProgress>& agents) const;
  std::string why_unknown(const MatchResult& result, const gamelog::MatchRecord& record,
                          const analysis::MatchSummary& summary,
                          const std::vector<AgentProgress>& agents) const;
  static void warn_of_other_scores(MatchResult& result, const std::vector<AgentProgress>& agents);
  void report_unknown(MatchResult& result, bool has_agents, const std::string& why) const;
  void report_write_error(MatchResult& result) const;
  bool has_written_whole_log() const;
  bool is_cut(int cycles, bool over, const std::vector<AgentProgress>& agents) const;

  const MatchOptions& options_;
  MatchPlan plan_;
  process::ProcessHost* host_;
  std::filesystem::path folder_;
  ServerOutput output_;
  std::size_t reported_intrusions_ = 0;
  process::SocketOwners owners_ = process::SocketOwners::of_own_programs();
  std::int64_t seen_connections_ = 0;
  std::optional<Intruder> intruder_;
  std::vector<std::string> warnings_;
  GameLogFollower log_;
  bool left_over_ = false;  ///< the match was over, as far as it knows, when it left the server
  std::shared_ptr<process::Child> child_;  ///< null: not started by cls
  ClaimedNames names_;
  soccer::PerSide<std::unique_ptr<ServerRelay>> relays_;  ///< null: the side needs none
  std::unique_ptr<process::ConnectionTrap> trap_;         ///< null: no side has a relay
};

/// Writes the events of a match that has ended, from its result and from the server's game log in
/// `folder`, if there is one.
void write_events(EventRecorder& events, const std::filesystem::path& folder,
                  const MatchResult& result);

}  // namespace cls::match
