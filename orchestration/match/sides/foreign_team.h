// A `team:` side under way: its agents as processes, joined one after the other.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/match/options/team_folder.h"
#include "orchestration/match/result/match_result.h"
#include "orchestration/match/server/server_output.h"
#include "orchestration/process/process_host.h"

namespace cls::orchestration::match {

/// Starts the agents of a team goalie first, each when the one before is on the pitch, so that
/// uniform numbers are what the start script was told.
class ForeignTeam {
 public:
  /// `host` must outlive the team. Nothing is started yet.
  ForeignTeam(TeamPlan plan, process::ProcessHost& host) : plan_(std::move(plan)), host_(host) {}

  /// Goes on with joining: starts the next agent as soon as the server has announced the one
  /// before. `news` is the latest from the server, `others` the names of teams that are not this
  /// one. The error says what cannot be started.
  base::Result<void> join(const ServerNews& news, const std::vector<std::string>& others);

  /// All eleven are on the pitch, and the coach was started.
  bool joined() const { return joined_; }
  /// What is still missing, for people: "player 3 of the left team has not joined".
  std::string waiting_for() const;
  /// The name under which the team plays; empty before its first player joined.
  const std::string& name() const { return name_; }

  /// An agent that has ended, if any.
  const process::Child* dead_agent() const;
  /// The agent that was started last; nullptr before the first.
  const process::Child* latest_agent() const {
    return agents_.empty() ? nullptr : agents_.back().get();
  }

  /// Starts the kill script, if there is one. It may end agents of others, looking for its own by
  /// name; that is the team's affair.
  void call_kill_script();
  /// Gives the kill script its second, then ends whatever is left, without waiting for that.
  void end(std::chrono::milliseconds grace);
  /// Waits until nothing is left.
  void wait_gone(std::chrono::milliseconds limit) const;

  double cpu_seconds() const;
  std::vector<ProcessResult> results() const;
  const TeamPlan& plan() const { return plan_; }

 private:
  base::Result<void> start_next();
  bool find_name(const ServerNews& news, const std::vector<std::string>& others);

  TeamPlan plan_;
  process::ProcessHost& host_;
  std::string name_;
  std::vector<std::shared_ptr<process::Child>> agents_;
  std::shared_ptr<process::Child> kill_script_;
  std::chrono::steady_clock::time_point kill_script_until_;
  int on_pitch_ = 0;
  bool joined_ = false;
};

}  // namespace cls::orchestration::match
