// A cls team or trainer: Playmaker, agents and the thread they run on.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/system/worker.h"
#include "match/sides/match_side.h"
#include "match/sides/playmaker_process.h"
#include "match/terms/match_options.h"
#include "mock-server/server.h"
#include "proxy/agent/team.h"
#include "proxy/playmaker/call_watch.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::match {

/// The match as a side needs to know it.
struct SideSetup {
  soccer::Side side = soccer::Side::kLeft;  ///< neutral: the trainer, which has no players
  std::string name;                         ///< team name; of a trainer the left team's
  std::uint64_t seed = 0;
  std::filesystem::path folder;          ///< of the match
  process::ProcessHost* host = nullptr;  ///< for sides that start programs
  std::vector<int> cpus;                 ///< processor cores of agents and Playmaker; empty: all
  process::ResourceLimits limits{};      ///< of the Playmaker's processes
  proxy::BatchMode batch = proxy::BatchMode::kOff;
  proxy::RpcTimeout team_reply = proxy::kNoTimeout;     ///< for RegisterTeam, once connected
  std::shared_ptr<PlaymakerSandbox> sandbox = nullptr;  ///< of the Playmakers; null: none
};

/// A Playmaker as a match uses it, with the programs behind it.
struct PlaymakerConnection {
  Endpoint endpoint;
  std::unique_ptr<mock_server::Server> mock;  ///< for a mock
  bool direct = false;                        ///< the mock decides on the side's thread
  std::unique_ptr<PlaymakerProcess> process;  ///< for a `run:` side
  std::unique_ptr<proxy::Playmaker> playmaker;
  std::vector<PlaymakerConnection> parts;  ///< of a mixed side, whose `playmaker` calls theirs
};

/// Starts the bundled mocks and the user's commands that the endpoint asks for. Nothing is sent to
/// a Playmaker that runs already.
base::Result<PlaymakerConnection> connect_playmaker(const Endpoint& endpoint,
                                                    const SideSetup& setup);

/// The options of a team for a match.
proxy::TeamOptions team_options(const SideSetup& setup, const Endpoint& endpoint,
                                const MatchOptions& options);

/// The parts of a side of cls agents.
struct AgentParts {
  SideIdentity identity;
  PlaymakerConnection connection;
  proxy::TeamOptions team;
  const MatchOptions& options;  ///< must outlive the side
  std::vector<int> cpus{};
  std::shared_ptr<PlaymakerSandbox> sandbox = nullptr;  ///< null: none
};

/// The result of a player of a cls team.
PlayerResult result_of(int number, const proxy::AgentStatistics& statistics);

/// Agents of cls, in lockstep or over UDP. The team may be used by the worker's thread
/// only while work is under way there.
class AgentSide : public MatchSide {
 public:
  explicit AgentSide(AgentParts parts);

  bool listen(SideListener& listener) override;
  std::optional<proxy::AwaitedCall> awaited_reply() const override { return watch_.oldest(); }
  TurnTimes turn_times() const override;
  const proxy::LatencySamples* turn_samples() const override { return &team_->times().turn_us; }
  std::string timeout_hint() const override;
  const process::Child* awaited_process() const override;
  std::optional<MatchEnd> failure(const MatchMoment& moment) override;
  void cancel() override { connection_.playmaker->cancel(); }
  std::string excess(bool at_once) override;
  std::vector<ProcessResult> wait_gone() override;
  std::vector<std::string> failed_expectations() const override;
  const proxy::PlaymakerErrors* errors() const override { return &team_->errors(); }
  TeamResult result() const override;

  const proxy::Team& team() const { return *team_; }
  /// CPU time of this side's mocks, but for those called as functions: they are part of the team.
  double mock_cpu_seconds() const;

 protected:
  bool is_trainer() const { return identity().side == soccer::Side::kNeutral; }
  const MatchOptions& options() const { return options_; }
  /// The programs of the side: those of all parts of a mixed one.
  std::vector<const PlaymakerProcess*> playmaker_processes() const;
  proxy::Team& team() { return *team_; }
  base::Worker& worker() { return worker_; }
  void begin_listening(int cycle);
  void end_listening();
  /// The team calls this Playmaker from now on; before the handshake.
  void replace_playmaker(std::unique_ptr<proxy::Playmaker> playmaker);
  /// "brain (localhost:50051): no answer to Register of player 1".
  std::string no_answer() const;
  /// Introduces the team; how that ends the match if it fails.
  std::optional<MatchEnd> shake_hands();
  /// Why the agents cannot continue, apart from their Playmaker's process.
  virtual std::optional<MatchEnd> agent_failure(const MatchMoment& moment) = 0;

 private:
  /// The connection itself, or the parts of a mixed side.
  std::vector<const PlaymakerConnection*> connections() const;
  /// The one whose reply is awaited; without a call the only one, or nullptr.
  const PlaymakerConnection* awaited_connection() const;
  void add_parts(TeamResult& result) const;

  std::shared_ptr<PlaymakerSandbox> sandbox_;  ///< null: none
  PlaymakerConnection connection_;
  const MatchOptions& options_;
  proxy::CallWatch watch_;
  std::unique_ptr<proxy::Playmaker> watched_;  ///< the connection's Playmaker, watched
  std::vector<SideListener*> listeners_;
  std::vector<std::unique_ptr<proxy::Playmaker>> listened_;  ///< `watched_` with listeners
  std::unique_ptr<proxy::Team> team_;
  base::Worker worker_;
};

}  // namespace cls::match
