// A match one cycle at a time: `--step`, `--at CYCLE`.
#pragma once

#include <atomic>
#include <iosfwd>
#include <string>

#include "orchestration/match/hooks/match_director.h"

namespace cls::cli {

/// From game time `first` on, waits before the Playmakers are asked about a cycle, until a line
/// comes: empty for one cycle, a number for so many, c to go on, q to end. The end of the input
/// means c.
class MatchStepper : public orchestration::match::MatchDirector {
 public:
  /// Reads from descriptor `input`; a signal ends the waiting.
  MatchStepper(int first, int input, const std::atomic<int>& signal)
      : first_(first), input_(input), signal_(signal) {}

  void before_decisions(const simulator::World& world) override;
  bool after_cycle(const simulator::World& world) override;

 private:
  /// False at the end of the input or when a signal came.
  bool read_line(std::string& line);
  void obey(const std::string& line);

  int first_;
  int input_;
  const std::atomic<int>& signal_;
  int passing_ = 0;  ///< cycles to let pass before the next stop
  bool waiting_ = false;
  bool going_on_ = false;
  bool ending_ = false;
  std::string pending_;
};

}  // namespace cls::cli
