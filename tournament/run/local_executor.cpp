// Plays matches as processes on this host.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <thread>
#include <utility>

#include "base/system/host.h"
#include "tournament/run/match_executor.h"
#include "tournament/slots/concurrency.h"
#include "tournament/store/match_attempt.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using base::Result;

class LocalExecutor : public MatchExecutor {
 public:
  LocalExecutor(const TournamentConfig& config, fs::path folder, fs::path program,
                process::ProcessHost host)
      : config_(config),
        folder_(std::move(folder)),
        program_(std::move(program)),
        concurrency_(config, base::usable_cores()),
        cores_(config.execution.pin ? base::allowed_cores() : std::vector<std::vector<int>>()),
        host_(std::move(host)) {
    const std::string team = fixed_port_team(config);
    if (team.empty() || config.execution.concurrency == 1) return;
    notes_.push_back(fmt::format("one match at a time: {} requires the ports 6000 to 6002", team));
  }

  int free_slots() const override { return std::max(0, concurrency_.current() - running()); }
  int running() const override { return static_cast<int>(attempts_.size() + played_.size()); }

  Result<void> start(std::span<const Assignment> assignments) override {
    for (const Assignment& assignment : assignments) {
      // `work` may have played it since the run looked; a new attempt would replace its folder.
      if (auto outcome = recover_result(config_, assignment.fixture, assignment.number, folder_)) {
        played_.push_back({assignment.fixture.index, std::move(outcome)});
        continue;
      }
      const int slot = free_slot();
      TRY_INIT(auto attempt,
               MatchAttempt::start(
                   host_, config_, assignment.fixture, assignment.number,
                   {folder_, {}, program_, cpus_of_slot(cores_, slot, concurrency_.current())}));
      attempts_.emplace(slot, std::move(attempt));
    }
    return {};
  }

  Result<std::vector<FinishedMatch>> wait(std::chrono::milliseconds limit) override {
    constexpr std::chrono::milliseconds kPollInterval{2};
    const auto end = std::chrono::steady_clock::now() + limit;
    std::vector<FinishedMatch> finished = std::exchange(played_, {});

    while (true) {
      for (auto at = attempts_.begin(); at != attempts_.end();) {
        at->second.end_overdue();
        if (!at->second.exited()) {
          ++at;
          continue;
        }
        TRY_INIT(auto outcome, at->second.outcome());
        if (outcome) adapt(*outcome);
        finished.push_back({at->second.fixture().index, std::move(outcome)});
        at = attempts_.erase(at);
      }

      if (!finished.empty() || std::chrono::steady_clock::now() >= end) return finished;
      std::this_thread::sleep_for(kPollInterval);
    }
  }

  void interrupt() override {
    for (auto& [slot, attempt] : attempts_) attempt.interrupt();
  }

  std::vector<std::string> take_notes() override { return std::exchange(notes_, {}); }

 private:
  int free_slot() const {
    int slot = 0;
    while (attempts_.contains(slot)) ++slot;
    return slot;
  }

  void adapt(const Outcome& outcome) {
    const int before = concurrency_.current();
    if (!concurrency_.adapt(outcome)) return;
    notes_.push_back(
        fmt::format("{} parallel matches now, {} before: {}", concurrency_.current(), before,
                    concurrency_.current() < before ? "a match missed cycles, the host was too busy"
                                                    : "no match missed a cycle"));
  }

  const TournamentConfig& config_;
  fs::path folder_;
  fs::path program_;
  Concurrency concurrency_;
  std::vector<std::vector<int>> cores_;  // to divide among matches; empty: no pinning
  process::ProcessHost host_;
  std::map<int, MatchAttempt> attempts_;  // by slot
  std::vector<FinishedMatch> played_;     // by others, before their attempt began
  std::vector<std::string> notes_;
};

}  // namespace

Result<std::unique_ptr<MatchExecutor>> make_executor(const TournamentConfig& config,
                                                     const fs::path& folder,
                                                     const fs::path& program) {
  switch (config.execution.executor) {
    case ExecutorKind::kSlurm:
      return slurm_executor(config, folder, program);
    case ExecutorKind::kHosts:
      return hosts_executor(config, folder, program);
    case ExecutorKind::kLocal:
      break;
  }
  return local_executor(config, folder, program);
}

Result<std::unique_ptr<MatchExecutor>> local_executor(const TournamentConfig& config,
                                                      const fs::path& folder,
                                                      const fs::path& program) {
  TRY_INIT(auto host, process::ProcessHost::create());
  return std::unique_ptr<MatchExecutor>(
      std::make_unique<LocalExecutor>(config, folder, program, std::move(host)));
}

}  // namespace cls::tournament
