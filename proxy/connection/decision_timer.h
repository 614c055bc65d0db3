// Decides when a player decides: on (think), or by messages and clock in real time.
#pragma once

#include <chrono>
#include <cstdint>

#include "soccer/protocol/view_mode.h"

namespace cls::proxy {

using Instant = std::chrono::steady_clock::time_point;

/// Delays after sense_body in real time, for a server at normal speed.
struct DecisionDelays {
  std::chrono::milliseconds no_see{
      5};  ///< no see is due: for the hear messages sent with sense_body
  std::chrono::milliseconds synch_see{30};  ///< a see is due with sense_body, not received yet
  std::chrono::milliseconds see{75};        ///< without synchronous see
};

/// Decides once per sense_body (docs/spec/proxy-behavior.md 2.1). In synchronous mode on (think).
/// In real time when the see message of the cycle arrives, otherwise when it is no longer expected.
/// Reads no clock; the caller passes times.
class DecisionTimer {
 public:
  explicit DecisionTimer(DecisionDelays delays = {}) : delays_(delays) {}

  /// From the server's parameters. The slow-down factor multiplies all delays.
  void set_synchronous(bool synchronous) { synchronous_ = synchronous; }
  void set_slow_down(int factor) { slow_down_ = factor; }
  /// See messages arrive with sense_body; the server confirmed (ok synch_see).
  void set_synch_see(bool synch_see) { synch_see_ = synch_see; }

  /// Begins a cycle.
  void on_sense_body(Instant received_at, soccer::ViewWidth width);
  void on_see(Instant received_at);
  void on_think(Instant received_at);

  /// True when a decision is due. Pass the epoch in synchronous mode, where only (think) counts.
  bool due(Instant now) const { return open_ && now >= due_at_; }
  /// Due time; the far future when only a message can make the decision due.
  Instant due_at() const { return open_ ? due_at_ : Instant::max(); }
  /// The decision has begun.
  void decided() {
    open_ = false;
    begun_ = true;
  }

  /// Arrival of the current cycle's sense_body.
  Instant cycle_began() const { return cycle_began_; }
  bool synchronous() const { return synchronous_; }

  /// Cycles without a decision since the first decision.
  std::int64_t undecided() const { return undecided_; }

 private:
  bool expects_see(soccer::ViewWidth width) const;

  DecisionDelays delays_;
  bool synchronous_ = true;
  bool synch_see_ = false;
  int slow_down_ = 1;
  bool open_ = false;   ///< no decision in the current cycle yet
  bool begun_ = false;  ///< at least one decision was made
  Instant cycle_began_;
  Instant due_at_ = Instant::max();
  int since_see_ = 0;  ///< sense_body messages since the last see
  bool seen_ = false;  ///< at least once
  std::int64_t undecided_ = 0;
};

}  // namespace cls::proxy
