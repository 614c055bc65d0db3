// An external team (`team:DIR`): its agents are processes that speak the soccer server's protocol.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "match/programs/team_folder.h"
#include "match/server/match_server.h"
#include "match/sides/match_side.h"
#include "match/sides/side_use.h"
#include "match/terms/side_limits.h"
#include "process/process_host.h"
#include "process/scratch_folder.h"

namespace cls::match {

/// Starts the goalie first and each further agent when the one before is on the pitch, so that
/// uniform numbers are those that the start script was called with.
class ExternalSide : public MatchSide {
 public:
  /// The policy for a team that plays under another name than it was given.
  enum class OnOtherName { kAccept, kWarn, kRefuse };

  /// `server` and `host` must outlive the side. Nothing is started yet. The programs start in
  /// `namespaces`; null: in those of cls. Together they may use of the host what `limits` says.
  ExternalSide(SideIdentity identity, TeamPlan plan, OnOtherName on_other_name, Server& server,
               process::ProcessHost& host, const SideLimits& limits = {},
               std::shared_ptr<const process::Namespaces> namespaces = nullptr)
      : MatchSide(std::move(identity)),
        plan_(std::move(plan)),
        on_other_name_(on_other_name),
        server_(server),
        host_(host),
        limits_(limits),
        use_(this->identity().side, limits),
        namespaces_(std::move(namespaces)) {}

  bool is_external() const override { return true; }
  std::string team_name() const override { return name_.empty() ? identity().name : name_; }
  std::optional<MatchEnd> join(const ServerStatus& server,
                               const std::vector<std::string>& others) override;
  bool joined() const override { return joined_; }
  std::string waiting_for() const override;
  std::string timeout_hint() const override;
  const process::Child* awaited_process() const override;
  std::optional<MatchEnd> failure(const MatchMoment& moment) override;
  std::optional<MatchEnd> final_failure(const MatchMoment& moment) override;
  std::vector<std::string> take_warnings() override;
  std::string excess(bool at_once) override { return use_.excess(at_once); }
  void leave() override;
  void terminate() override;
  std::vector<ProcessResult> wait_gone() override;
  TeamResult result() const override;

 private:
  /// A started agent.
  struct Agent {
    int unum = 0;  ///< 0: the whole team
    std::shared_ptr<process::Child> child;
  };
  /// An agent that exited during play: before the match ended, or because it ended?
  struct AgentExit {
    const process::Child* child = nullptr;
    int cycle = 0;
    std::chrono::steady_clock::time_point at;
  };

  base::Result<void> continue_joining(const ServerStatus& server,
                                      const std::vector<std::string>& others);
  base::Result<void> start_next();
  base::Result<void> make_temporary_folder();
  base::Result<void> begin_use();
  base::Result<std::shared_ptr<process::Child>> start(process::CommandPlan plan);
  bool find_name(const ServerStatus& server, const std::vector<std::string>& others);
  base::Result<void> check_name();
  const Agent* exited_agent() const;
  const Agent* wait_for_exited_agent() const;
  void warn_of_missing_coach(const MatchMoment& moment);
  std::optional<MatchEnd> lost_player_failure(const MatchMoment& moment);
  MatchEnd exit_failure(const process::Child& child, const MatchMoment& moment) const;
  bool exited_before_the_end(int cycle) const;
  std::string limit_hints() const;
  std::string options_hint(const process::Child& child) const;
  bool may_be_refused_for_its_name(const process::Child& child) const;

  TeamPlan plan_;
  OnOtherName on_other_name_;
  Server& server_;
  process::ProcessHost& host_;
  SideLimits limits_;
  SideUse use_;
  std::shared_ptr<const process::Namespaces> namespaces_;
  std::optional<process::ScratchFolder> temporary_;  ///< of a team in a sandbox
  std::string name_;              ///< that the team plays under; empty before its first player
  std::string shared_name_hint_;  ///< while the team has not been seen, but another one has
  std::vector<Agent> agents_;
  std::optional<AgentExit> exit_;
  std::vector<std::shared_ptr<process::Child>> kill_scripts_;
  std::chrono::steady_clock::time_point kill_script_deadline_;
  int on_pitch_ = 0;
  bool joined_ = false;
  bool looked_for_coach_ = false;
  bool warned_of_limit_ = false;
  std::vector<std::string> warnings_;
};

}  // namespace cls::match
