// One match: a server, its sides, and everything that may end it.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "orchestration/match/hooks/match_hooks.h"
#include "orchestration/match/match_limits.h"
#include "orchestration/match/match_speed.h"
#include "orchestration/match/options/match_options.h"
#include "orchestration/match/result/match_observer.h"
#include "orchestration/match/result/match_result.h"
#include "orchestration/match/server/server.h"
#include "orchestration/match/sides/match_side.h"

namespace cls::orchestration::match {

/// Use: add_hooks, play once, then result(). The sides use threads of their own. In lockstep server
/// and sides never run at the same time, so what happens depends on seed, parameters and the
/// Playmakers' replies only.
class Match {
 public:
  /// Where the wall time of a match in lockstep went, in seconds.
  struct Times {
    double server = 0.0;  ///< steps
    double sides = 0.0;   ///< waiting for decisions
    double play = 0.0;    ///< from the first step to the last
  };

  /// `sides`: left, right, and the trainer if there is one; or one side alone, wherever it plays
  /// (`cls proxy`). `options` and `stop_signal` must outlive the match.
  Match(const MatchOptions& options, std::unique_ptr<Server> server,
        std::vector<std::unique_ptr<MatchSide>> sides, std::uint64_t seed,
        const std::atomic<int>& stop_signal);

  /// Several hooks are called in this order. Before play(); they must outlive the match.
  void add_hooks(MatchHooks& hooks);

  /// Starts the server, lets the sides join, plays to the end, and leaves no process running.
  void play(MatchObserver& observer);

  /// The whole result except files and times of the run.
  const MatchResult& result() const { return result_; }
  const std::vector<std::unique_ptr<MatchSide>>& sides() const { return sides_; }
  const Server& server() const { return *server_; }
  const Times& times() const { return times_; }

 private:
  using Clock = MatchLimits::Clock;

  /// What the match waits for, for the message when a limit is exceeded.
  struct Awaited {
    std::function<std::string()> what;
    const MatchSide* side = nullptr;        ///< at fault; its hint is added to the message
    const process::Child* child = nullptr;  ///< reported as the process that failed
  };

  void warn_of_deadline();
  void prepare_sides();
  void start_server();
  void join_sides();
  void shake_hands();
  void play_cycles();
  void throttle(Clock::time_point start) const;
  void observe();
  bool turn_is_due() const;
  void take_turn();
  void wait_for_decisions();
  void wait_for_external_clients();
  void finish();
  void make_result();

  /// False when the match ended first.
  bool wait_for(const MatchSide& side, const std::function<bool()>& reached);
  void check();
  void end(MatchEnd end);
  void end_unless_interrupted(MatchEnd end);
  void end_by_side(const MatchSide& side, MatchEnd end);
  void end_by_limit(EndReason limit);
  void end_by_stall();
  std::optional<EndReason> exceeded_limit() const;
  void warn_of_slow_reply();
  void cancel_calls();
  bool ended() const { return end_.has_value(); }
  /// True when the server or a side has seen the last cycle.
  bool is_over() const;
  bool at_cycle_limit() const;
  SourceProgress progress() const;
  MatchView view() const;
  MatchMoment moment() const { return {playing_, progress().match.cycle}; }
  std::vector<AgentProgress> agent_progress() const;

  void warn(std::string line);
  void report_warnings();
  void report_disconnects();

  const MatchOptions& options_;
  std::uint64_t seed_;
  MatchLimits limits_;
  std::unique_ptr<Server> server_;
  std::vector<std::unique_ptr<MatchSide>> sides_;
  std::vector<MatchHooks*> hooks_;
  MatchObserver* observer_ = nullptr;  ///< of play()
  bool playing_ = false;
  std::optional<MatchEnd> end_;
  Awaited awaited_;
  int missed_by_external_ = 0;    ///< cycles in a row without all replies of external clients
  std::int64_t steps_ = 0;        ///< most that was seen by any source
  Clock::time_point stepped_at_;  ///< when that was
  Clock::time_point first_cycle_;
  Clock::time_point last_cycle_;
  std::map<std::string, std::size_t> reported_disconnects_;  ///< by team
  std::array<bool, 3> warned_of_slow_reply_{};               ///< by side
  std::vector<std::string> warnings_;
  std::vector<ProcessResult> processes_;
  MatchResult result_;
  Times times_;
  MatchSpeed speed_;
  Clock::time_point play_began_;
  std::chrono::nanoseconds played_{0};
};

}  // namespace cls::orchestration::match
