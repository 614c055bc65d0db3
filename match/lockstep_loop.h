// A match on the embedded server: a step, then the decisions about it, and so on.
#pragma once

#include <chrono>
#include <optional>

#include "match/match_guard.h"
#include "match/match_loop.h"
#include "match/match_speed.h"
#include "match/server/embedded_server.h"

namespace cls::match {

/// Server and sides never run at the same time, so what happens depends on seed, parameters and the
/// Playmakers' replies only.
class LockstepLoop : public MatchLoop {
 public:
  /// All must outlive the loop.
  LockstepLoop(const MatchOptions& options, EmbeddedServer& server, const Sides& sides,
               MatchGuard& guard)
      : options_(options),
        server_(server),
        sides_(sides),
        guard_(guard),
        speed_(options, sides, MatchSpeed::Measure::kCycles) {}

  MatchMode mode() const override { return MatchMode::kLockstep; }
  void prepare() override {}
  void play(const Hooks& hooks) override;
  bool is_over() const override { return server_.finished(); }
  void finish(const MatchEnd& /*end*/) override { server_.finish(); }
  LoopTimes times() const override { return times_; }
  std::optional<SpeedResult> speed(const MatchResult& result) override;
  bool blames(const MatchSide& /*side*/) const override { return true; }
  bool needs_sides() const override { return true; }
  void on_failure() override { cancel_calls(); }

 private:
  using Clock = std::chrono::steady_clock;

  void arrange(const Hooks& hooks);
  void play_cycle(const Hooks& hooks);
  void throttle() const;
  void observe();
  void take_turn(const Hooks& hooks);
  void wait_for_decisions();
  void wait_for_external_clients();
  void cancel_calls();
  MatchView view() const;

  const MatchOptions& options_;
  EmbeddedServer& server_;
  const Sides& sides_;
  MatchGuard& guard_;
  MatchSpeed speed_;
  LoopTimes times_;
  Clock::time_point began_;
  std::chrono::nanoseconds played_{0};
  int missed_by_external_ = 0;  ///< cycles in a row without all replies of external clients
};

}  // namespace cls::match
