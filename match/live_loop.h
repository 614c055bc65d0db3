// A match over UDP, on a server that advances without the match.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "match/match_guard.h"
#include "match/match_loop.h"
#include "match/match_speed.h"
#include "match/server/external_server.h"

namespace cls::match {

/// Polls server and sides, which have threads and processes of their own. With --step the sides
/// hold the server, and take their turns when all of them wait for one.
class LiveLoop : public MatchLoop {
 public:
  /// All must outlive the loop.
  LiveLoop(const MatchOptions& options, ExternalServer& server, const Sides& sides,
           MatchGuard& guard)
      : options_(options),
        server_(server),
        sides_(sides),
        guard_(guard),
        speed_(options, sides, MatchSpeed::Measure::kWholeMatch) {}

  MatchMode mode() const override;
  void prepare() override;
  void play(const Hooks& hooks) override;
  bool is_over() const override;
  void finish(const MatchEnd& end) override;
  LoopTimes times() const override;
  std::optional<SpeedResult> speed(const MatchResult& result) override;
  /// A side that has not called its Playmaker yet may wait for the server. An external team has its
  /// places for itself where clients are bound to their side.
  bool blames(const MatchSide& side) const override {
    return side.awaited_reply().has_value() ||
           (side.is_external() && server_.keeps_places(side.identity().side));
  }
  bool needs_sides() const override { return !is_over(); }

 private:
  using Clock = std::chrono::steady_clock;

  void warn_of_deadline();
  void observe();
  bool turn_is_due() const;
  void take_turn(const Hooks& hooks);
  void report_disconnects();
  void end_by_final_failure();
  /// True if the agents of a side have seen this.
  bool has_seen(bool SeenMatch::*what) const;
  bool at_cycle_limit() const;
  bool takes_turns() const;
  MatchView view() const;

  const MatchOptions& options_;
  ExternalServer& server_;
  const Sides& sides_;
  MatchGuard& guard_;
  MatchSpeed speed_;
  std::int64_t steps_ = 0;        ///< most that was seen by any source
  Clock::time_point stepped_at_;  ///< when that was
  Clock::time_point began_;
  Clock::time_point first_cycle_;
  Clock::time_point last_cycle_;
  std::chrono::nanoseconds played_{0};
  std::map<std::string, std::size_t> reported_disconnects_;  ///< by team
};

}  // namespace cls::match
