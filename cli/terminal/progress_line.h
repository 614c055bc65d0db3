// Progress line of a running match.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "cli/terminal/terminal.h"
#include "match/result/match_observer.h"

namespace cls::cli {

/// Rewrites one line on stderr every 100 ms; notices and warnings are printed above it. Without a
/// terminal only notices and warnings are printed, so that a log file stays readable.
class ProgressLine : public match::MatchObserver {
 public:
  /// `shown` is false without a terminal and with --quiet.
  ProgressLine(bool shown, bool quiet) : shown_(shown), quiet_(quiet) {}

  void on_phase(std::string_view what) override;
  void on_cycle(const match::MatchProgress& progress) override;
  void on_notice(std::string_view line) override;
  void on_warning(std::string_view line) override;

  /// Erases the line.
  void clear() { line_.clear(); }

 private:
  using Clock = std::chrono::steady_clock;

  bool shown_;
  bool quiet_;
  TerminalLine line_;
  Clock::time_point last_shown_{};
  Clock::time_point first_cycle_{};
  int cycles_at_start_ = -1;
};

/// Text of the line: game time, score, play mode, speed and the remaining time.
std::string progress_text(const match::MatchProgress& progress, double cycles_per_second);

}  // namespace cls::cli
