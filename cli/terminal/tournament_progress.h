// Progress of a tournament on stderr.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "cli/terminal/terminal.h"
#include "tournament/run/tournament_run.h"

namespace cls::cli {

/// Prints a line per finished match and notes, and the status: on a terminal as a progress line
/// below, otherwise as a line once a minute. Nothing if quiet.
class TournamentProgress : public tournament::TournamentObserver {
 public:
  TournamentProgress(bool on_terminal, bool quiet) : on_terminal_(on_terminal), quiet_(quiet) {}

  /// Matches of earlier runs, which count for who leads.
  void resume(const tournament::TournamentConfig& config,
              const std::vector<tournament::ScheduledMatch>& matches);

  void on_progress(const tournament::RunProgress& progress) override;
  void on_match(const tournament::TournamentConfig& config, const tournament::ScheduledMatch& match,
                const tournament::RunProgress& progress) override;
  void on_note(std::string_view line) override;

  void clear() { line_.clear(); }

 protected:
  /// Text of the status.
  virtual std::string status(const tournament::RunProgress& progress) const;
  /// True when a status line is due without a terminal, `since_last` after the latest.
  virtual bool is_due(const tournament::RunProgress& progress,
                      std::chrono::steady_clock::duration since_last);

 private:
  using Clock = std::chrono::steady_clock;

  void print(std::string_view line);
  void find_leader(const tournament::TournamentConfig& config);

  bool on_terminal_;
  bool quiet_;
  TerminalLine line_;
  std::vector<tournament::ScheduledMatch> played_;
  std::string leader_;  ///< "RED leads"; empty: not known
  Clock::time_point last_leader_{};
  Clock::time_point last_status_ = Clock::now();
};

/// "[######....] 12/20 matches  2 running  1 invalid  4.1 a minute  2:05 min left".
std::string progress_text(const tournament::RunProgress& progress);

/// "match 3/12  A 2:1 B  (finished, 4.2 s, 1 warning)"; of an invalid match "A - B  (crashed, 1.0
/// s): ..." with what went wrong. `match` has an outcome.
std::string match_line(const tournament::TournamentConfig& config,
                       const tournament::ScheduledMatch& match, int total);

}  // namespace cls::cli
