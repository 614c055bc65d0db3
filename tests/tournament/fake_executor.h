// A fake executor and made-up results: tournaments without playing matches.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tournament/config/config.h"
#include "tournament/run/match_executor.h"
#include "tournament/schedule/fixture.h"

namespace cls::tournament {

/// Teams A, B, C, ... on mocks.
TournamentConfig config_of(Format format, int teams);

/// The outcome of a finished match.
Outcome score(int left, int right);

/// The outcome of a match that ended for `reason` by the left side's fault.
Outcome fault(match::EndReason reason);

/// Decides the outcome of a fixture.
using Referee = std::function<Outcome(const Fixture&)>;

/// The team with the lower index wins 1:0.
Outcome better_wins(const Fixture& fixture);

/// Plays until the tournament is complete.
std::vector<ScheduledMatch> play_all(const TournamentConfig& config, const Referee& referee);

/// "A-B" for each fixture.
std::vector<std::string> pairs_of(const std::vector<Fixture>& fixtures);
std::vector<std::string> pairs_of(const std::vector<ScheduledMatch>& matches);

/// Names of the teams in the last table, by rank.
std::vector<std::string> ranking(const TournamentConfig& config,
                                 const std::vector<ScheduledMatch>& matches);

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
