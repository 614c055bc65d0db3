// A fake executor: tournaments without playing matches.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/league/made_up_results.h"
#include "tournament/config/config.h"
#include "tournament/run/match_executor.h"

namespace cls::tournament {

/// Teams A, B, C, ... on mocks.
TournamentConfig config_of(Format format, int teams);

/// An executor without processes: matches end immediately, in the order of their start.
class FakeExecutor : public MatchExecutor {
 public:
  struct Record {
    std::vector<Assignment> started;
    int interruptions = 0;
  };

  /// `record` must outlive it. `referee` may return nothing for a match that never ends.
  FakeExecutor(std::function<std::optional<Outcome>(const Assignment&)> referee, Record& record,
               int capacity = 2)
      : referee_(std::move(referee)), record_(record), capacity_(capacity) {}

  int free_slots() const override { return capacity_ - running(); }
  int running() const override { return static_cast<int>(running_.size()); }
  base::Result<void> start(std::span<const Assignment> assignments) override;
  base::Result<std::vector<FinishedMatch>> wait(std::chrono::milliseconds limit) override;
  void interrupt() override;

 private:
  std::function<std::optional<Outcome>(const Assignment&)> referee_;
  Record& record_;
  int capacity_;
  std::vector<Assignment> running_;
  bool interrupted_ = false;
};

}  // namespace cls::tournament
