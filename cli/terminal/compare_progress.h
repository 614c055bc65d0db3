// Progress of `cls compare`: the state of its test.
#pragma once

#include <chrono>
#include <string>

#include "cli/terminal/tournament_progress.h"
#include "tournament/report/comparison.h"

namespace cls::cli {

/// Its status shows pairs, difference with its interval, the state of the test, and the time left;
/// without a terminal after the first pair, then with new pairs every 10 s.
class CompareProgress : public TournamentProgress {
 public:
  /// `comparison` and `known`, the verdict so far, must outlive this.
  CompareProgress(const tournament::Comparison& comparison,
                  const tournament::ComparisonVerdict& known, bool on_terminal, bool quiet)
      : TournamentProgress(on_terminal, quiet), comparison_(comparison), known_(known) {}

 protected:
  std::string status(const tournament::RunProgress& progress) const override;
  bool is_due(const tournament::RunProgress& progress,
              std::chrono::steady_clock::duration since_last) override;

 private:
  const tournament::Comparison& comparison_;
  const tournament::ComparisonVerdict& known_;
  double shown_samples_ = 0.0;
};

/// "pairs 12/20  +35 Elo (-120..+190)  evidence 1.2/20 for, 0.7/20 against  2:05 min left"; with
/// the SPRT "LLR +0.24 (-2.94..+2.94)". The time follows from the matches of this run.
std::string comparison_status(const tournament::Comparison& comparison,
                              const tournament::ComparisonVerdict& known,
                              const tournament::RunProgress& progress);

/// Before the first match of a run without a verdict: "pairs to play: 6 if NEW wins all, about 295
/// at H0 or H1, 540 halfway"; of a resumed one "pairs done: 12, to play: about 30".
std::string comparison_outlook(const tournament::Comparison& comparison,
                               const tournament::ComparisonVerdict& known);

}  // namespace cls::cli
