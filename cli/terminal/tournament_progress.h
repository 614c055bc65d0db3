// Progress of a tournament on a terminal.
#pragma once

#include <string>
#include <string_view>

#include "cli/terminal/terminal.h"
#include "orchestration/tournament/run/tournament_run.h"

namespace cls::cli {

/// Prints a line per finished match and a progress line below, both only on a terminal. Prints
/// notes unless quiet.
class TournamentProgress : public orchestration::tournament::TournamentObserver {
 public:
  TournamentProgress(bool shown, bool quiet) : shown_(shown), quiet_(quiet) {}

  void on_progress(const orchestration::tournament::RunProgress& progress) override;
  void on_match(const orchestration::tournament::TournamentConfig& config,
                const orchestration::tournament::ScheduledMatch& match,
                const orchestration::tournament::RunProgress& progress) override;
  void on_note(std::string_view line) override;

  void clear() { line_.clear(); }

 private:
  bool shown_;
  bool quiet_;
  TerminalLine line_;
};

/// "[######....] 12/20 matches  2 running  1 invalid  4.1 a minute  2:05 min left".
std::string progress_text(const orchestration::tournament::RunProgress& progress);

}  // namespace cls::cli
