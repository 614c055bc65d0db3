// Fake executor.
#include "tests/tournament/fake_executor.h"

#include <thread>

namespace cls::tournament {

TournamentConfig config_of(Format format, int teams) {
  TournamentConfig config;
  config.competition = league::competition_of(format, teams);
  return config;
}

base::Result<void> FakeExecutor::start(std::span<const Assignment> assignments) {
  for (const Assignment& assignment : assignments) {
    record_.started.push_back(assignment);
    running_.push_back(assignment);
  }
  return {};
}

base::Result<std::vector<FinishedMatch>> FakeExecutor::wait(std::chrono::milliseconds) {
  std::vector<FinishedMatch> finished;
  std::vector<Assignment> running;
  for (const Assignment& assignment : running_) {
    auto outcome = interrupted_ ? std::nullopt : referee_(assignment);
    if (!outcome && !interrupted_) {
      running.push_back(assignment);
      continue;
    }
    if (outcome) outcome->attempts = assignment.number;
    finished.push_back({assignment.fixture.index, std::move(outcome)});
  }
  running_ = std::move(running);
  if (finished.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return finished;
}

void FakeExecutor::interrupt() {
  interrupted_ = true;
  ++record_.interruptions;
}

}  // namespace cls::tournament
