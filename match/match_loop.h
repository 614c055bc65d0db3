// Advances a match from its first cycle to its last: in lockstep, or as its server does.
#pragma once

#include <optional>
#include <vector>

#include "match/hooks/match_hooks.h"
#include "match/result/match_end.h"
#include "match/result/match_result.h"
#include "match/result/speed.h"
#include "match/sides/match_side.h"
#include "match/terms/match_options.h"

namespace cls::match {

using Hooks = std::vector<MatchHooks*>;

/// Parts of the wall time of the cycles, in seconds.
struct LoopTimes {
  double server = 0.0;  ///< steps; in lockstep only
  double sides = 0.0;   ///< waiting for decisions; in lockstep only
  double play = 0.0;    ///< from the first cycle to the last
};

/// Implemented by LockstepLoop and LiveLoop. Use: prepare, play once, finish.
class MatchLoop {
 public:
  virtual ~MatchLoop() = default;

  /// The mode that the match was played in.
  virtual MatchMode mode() const = 0;

  /// Before the server starts.
  virtual void prepare() = 0;
  /// All sides have joined and registered: plays until the match has ended or is over.
  virtual void play(const Hooks& hooks) = 0;
  /// True when the server or a side has seen the last cycle.
  virtual bool is_over() const = 0;
  /// The match has ended like this, before its sides leave: completes the logs of the server or
  /// shuts it down.
  virtual void finish(const MatchEnd& end) = 0;

  /// After play().
  virtual LoopTimes times() const = 0;
  /// After wait_gone() of all sides: nothing if no cycle was played. `result` has the teams.
  virtual std::optional<SpeedResult> speed(const MatchResult& result) = 0;

  /// True when a side that does not join or register in time is at fault, and not the server.
  virtual bool blames(const MatchSide& side) const = 0;
  /// True while the failure of a side ends the match.
  virtual bool needs_sides() const = 0;
  /// The server or a side has failed, which has ended the match.
  virtual void on_failure() {}
};

}  // namespace cls::match
