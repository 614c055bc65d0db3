// A side that decides about a cycle when the match says so.
#pragma once

#include <chrono>

namespace cls::match {

/// Agents in lockstep, and agents over UDP with --step. Used by the match's thread only.
class TurnTaker {
 public:
  /// For wait_turn(): as long as the turn takes.
  static constexpr std::chrono::milliseconds kNoLimit = std::chrono::milliseconds::max();

  virtual ~TurnTaker() = default;
  /// True while the side waits for begin_turn().
  virtual bool at_turn() const { return true; }
  /// Lets the agents decide about the current cycle.
  virtual void begin_turn(int cycle) = 0;
  /// Takes a begun turn that has no thread of its own; after begin_turn() of all sides.
  virtual void take_turn() {}
  /// Waits until the turn is over; false after `limit`.
  virtual bool wait_turn(std::chrono::milliseconds /*limit*/) { return true; }
  virtual void end_turn() {}
};

}  // namespace cls::match
