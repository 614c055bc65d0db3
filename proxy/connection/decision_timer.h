// When a player decides: on (think), or by the messages and the clock of a cycle in real time.
#pragma once

#include <chrono>
#include <cstdint>

#include "soccer/protocol/view_mode.h"

namespace cls::proxy {

using Instant = std::chrono::steady_clock::time_point;

/// Thresholds of real time, for a server at normal speed.
struct DecisionDelays {
  std::chrono::milliseconds no_see{5};      ///< no see will come: for what is heard with sense_body
  std::chrono::milliseconds synch_see{30};  ///< a see is due with sense_body, and has not come
  std::chrono::milliseconds see{75};        ///< the same where see comes at times of its own
};

/// Decides once per sense_body (proxy behaviour 2.1). In synchronous mode when (think) comes. In
/// real time as soon as the see of the cycle is in; without one when it cannot be expected any
/// more. A value: knows of no clock but what it is told.
class DecisionTimer {
 public:
  explicit DecisionTimer(DecisionDelays delays = {}) : delays_(delays) {}

  /// As the server's parameters say. `slow_down` stretches all delays.
  void set_synchronous(bool synchronous) { synchronous_ = synchronous; }
  void set_slow_down(int factor) { slow_down_ = factor; }
  /// See messages come with sense_body, as the server confirmed by (ok synch_see).
  void set_synch_see(bool synch_see) { synch_see_ = synch_see; }

  /// A cycle begins.
  void on_sense_body(Instant arrived, soccer::ViewWidth width);
  void on_see(Instant arrived);
  void on_think(Instant arrived);

  /// Now is the time to decide. The epoch as `now` stands for "whatever the clock says", when only
  /// (think) counts.
  bool due(Instant now) const { return open_ && now >= due_at_; }
  /// From when on a decision is due; the far future as long as only a message can tell.
  Instant due_at() const { return open_ ? due_at_ : Instant::max(); }
  /// The decision has been made, or begun.
  void decided() {
    open_ = false;
    begun_ = true;
  }

  /// When the running cycle's sense_body came.
  Instant cycle_began() const { return cycle_began_; }
  bool synchronous() const { return synchronous_; }

  /// Cycles that passed without a decision since the first one.
  std::int64_t undecided() const { return undecided_; }

 private:
  bool expects_see(soccer::ViewWidth width) const;

  DecisionDelays delays_;
  bool synchronous_ = true;
  bool synch_see_ = false;
  int slow_down_ = 1;
  bool open_ = false;   ///< a cycle without a decision so far
  bool begun_ = false;  ///< a decision was made before
  Instant cycle_began_;
  Instant due_at_ = Instant::max();
  int since_see_ = 0;  ///< sense_bodies since the last see; counts up from 0 at the see
  bool seen_ = false;  ///< ever
  std::int64_t undecided_ = 0;
};

}  // namespace cls::proxy
