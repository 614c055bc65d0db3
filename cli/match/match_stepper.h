// Interactive stepping: `--step`, `--at CYCLE`.
#pragma once

#include <atomic>
#include <string>

#include "match/hooks/match_hooks.h"

namespace cls::cli {

/// From game time `first` on, waits before each cycle's decisions for an input line: empty for one
/// cycle, N for N cycles, c to continue, q to quit. End of input means c.
class MatchStepper : public match::MatchHooks {
 public:
  /// Reads from file descriptor `input`; stops waiting when `signal` is set.
  MatchStepper(int first, int input, const std::atomic<int>& signal)
      : first_(first), input_(input), signal_(signal) {}

  void before_decisions(const match::MatchView& view) override;
  bool after_cycle(const match::MatchView& view) override;

 private:
  /// False at end of input or after a signal.
  bool read_line(std::string& line);
  void execute(const std::string& line);

  int first_;
  int input_;
  const std::atomic<int>& signal_;
  int skip_ = 0;  ///< cycles to play before the next stop
  bool waiting_ = false;
  bool continue_ = false;
  bool quit_ = false;
  std::string pending_;
};

}  // namespace cls::cli
