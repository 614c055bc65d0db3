// One side of a match: its Playmaker, its team of agents and the thread they live on.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/system/worker.h"
#include "mock-server/server.h"
#include "orchestration/match/options/match_options.h"
#include "orchestration/match/result/match_result.h"
#include "orchestration/match/sides/playmaker_program.h"
#include "proxy/agent/team.h"
#include "proxy/playmaker/playmaker.h"
#include "proxy/playmaker/rpc_listener.h"

namespace cls::orchestration::match {

/// What a side needs to know of its match.
struct SideSetup {
  soccer::Side side = soccer::Side::kLeft;  ///< neutral: the trainer, who has no players
  std::string name;                         ///< of the team; a trainer's is the left one
  std::uint64_t seed = 0;
  std::filesystem::path folder;          ///< of the match
  process::ProcessHost* host = nullptr;  ///< for sides that start programs
  std::vector<int> cpus;                 ///< processors of agents and Playmaker; empty: all
};

/// What a player of ours did.
PlayerResult result_of(int number, const proxy::AgentStatistics& statistics);

/// Owns everything of one side. The team is used by `worker` only while work is under way there.
class MatchSide {
 public:
  /// Starts the bundled mock or the user's command if the endpoint asks for one; nothing is sent
  /// to a foreign Playmaker yet.
  static base::Result<std::unique_ptr<MatchSide>> create(const Endpoint& endpoint,
                                                         const SideSetup& setup,
                                                         const MatchOptions& options);

  /// `listener`, which must outlive the side, hears all calls; before the team is introduced.
  void listen(proxy::RpcListener& listener);

  proxy::Team& team() { return *team_; }
  const proxy::Team& team() const { return *team_; }
  proxy::Playmaker& playmaker() { return *playmaker_; }
  base::Worker& worker() { return worker_; }
  const std::string& name() const { return name_; }
  bool is_trainer() const { return is_trainer_; }
  const Endpoint& endpoint() const { return endpoint_; }
  /// The Playmaker as a process of ours; nullptr when it is none.
  const PlaymakerProgram* program() const { return program_.get(); }

  /// What the script of a mock side expected and did not get.
  std::vector<std::string> failed_expectations() const;

  /// What this side did; the score is the server's to tell.
  TeamResult result() const;
  /// CPU time of the bundled mock's decisions in seconds; 0 for a foreign Playmaker.
  double mock_cpu_seconds() const;

 private:
  MatchSide() = default;

  std::string name_;
  bool is_trainer_ = false;
  Endpoint endpoint_;
  std::unique_ptr<mock_server::Server> mock_;
  std::unique_ptr<PlaymakerProgram> program_;
  std::unique_ptr<proxy::Playmaker> playmaker_;
  std::vector<std::unique_ptr<proxy::Playmaker>> listened_;  ///< the Playmaker with listeners
  std::unique_ptr<proxy::Team> team_;
  base::Worker worker_;
};

}  // namespace cls::orchestration::match
