// Ends a match early, says whose fault that is, and warns the user.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "match/match_limits.h"
#include "match/match_loop.h"
#include "match/result/match_end.h"
#include "match/result/match_observer.h"
#include "match/server/match_server.h"
#include "match/sides/match_side.h"
#include "match/terms/match_options.h"

namespace cls::match {

/// Everything that waits for the server or a side waits here, and notices signals, limits and
/// failures meanwhile.
class MatchGuard {
 public:
  /// All must outlive the guard.
  MatchGuard(const MatchOptions& options, Server& server, const Sides& sides,
             const std::atomic<int>& stop_signal)
      : options_(options), limits_(options, stop_signal), server_(server), sides_(sides) {}

  /// Both come before all that follows, and must outlive the guard.
  void follow(MatchLoop& loop) { loop_ = &loop; }
  void report_to(MatchObserver& observer) { observer_ = &observer; }
  MatchObserver& observer() const { return *observer_; }

  /// The first end counts. An intruder is at fault for what ends a match, whichever side it hit.
  void end(MatchEnd end);
  /// Unless a signal ends the match, which may have ended the process that failed, too.
  void end_by_side(const MatchSide& side, MatchEnd end);
  /// Adds that `side`, which has failed, is at fault, unless it may be the victim.
  static void attribute(const MatchSide& side, MatchEnd& end);
  bool ended() const { return end_.has_value(); }
  const MatchEnd& how() const { return *end_; }
  const std::atomic<int>& signal() const { return limits_.signal(); }

  /// A new cycle has begun: the stall limit counts from here.
  void begin_cycle() { limits_.begin_cycle(); }
  /// Notices a game clock that stands still.
  void follow_clock(const SourceProgress& progress) { limits_.follow(progress); }
  /// The first cycle follows: failures from now on are those of a match.
  void begin_play() { playing_ = true; }

  /// Ends the match if it cannot continue.
  void check();
  /// Starts the server and waits for it.
  void start_server();
  /// Waits for `side` until `reached` returns true. False when the match ended first.
  bool wait_for(const MatchSide& side, const std::function<bool()>& reached);

  /// The progress of the match, as the server or a side has seen it.
  SourceProgress progress() const;
  MatchMoment moment() const { return {playing_, progress().match.cycle}; }

  void warn(std::string line);
  /// Passes on what the sides warn of.
  void report_warnings();
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  /// The awaited party, for the message when a limit is exceeded.
  struct Awaited {
    std::function<std::string()> what;
    const MatchSide* side = nullptr;        ///< at fault; its hint is added to the message
    const process::Child* child = nullptr;  ///< reported as the process that failed
  };

  void end_unless_interrupted(MatchEnd end);
  void end_by_limit(EndReason limit);
  void end_by_stall();
  std::optional<EndReason> exceeded_limit() const;
  void check_sides();
  void check_excess();
  void blame_excess(MatchEnd& end) const;
  void warn_of_slow_reply();

  const MatchOptions& options_;
  MatchLimits limits_;
  Server& server_;
  const Sides& sides_;
  MatchLoop* loop_ = nullptr;
  MatchObserver* observer_ = nullptr;
  bool playing_ = false;
  std::optional<MatchEnd> end_;
  Awaited awaited_;
  std::array<bool, 3> warned_of_slow_reply_{};  ///< by side
  std::vector<std::string> warnings_;
};

}  // namespace cls::match
