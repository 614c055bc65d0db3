// One match from start to result: a server, its sides, and the loop that advances them.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "match/match_guard.h"
#include "match/match_loop.h"
#include "match/result/match_observer.h"
#include "match/result/match_result.h"
#include "match/server/match_server.h"
#include "match/sides/match_side.h"
#include "match/terms/match_options.h"

namespace cls::match {

/// Use: add_hooks, play once, then result(). The sides use threads of their own.
class Match {
 public:
  /// Makes what advances the sides on the server of the match.
  using MakeLoop = std::function<std::unique_ptr<MatchLoop>(const Sides&, MatchGuard&)>;

  /// `sides`: left, right, and the trainer if there is one; or, over UDP, one side alone, wherever
  /// it plays (`cls proxy`). `options` and `stop_signal` must outlive the match.
  Match(const MatchOptions& options, std::unique_ptr<Server> server, Sides sides,
        const MakeLoop& make_loop, std::uint64_t seed, const std::atomic<int>& stop_signal);

  /// Several hooks are called in this order. Before play(); they must outlive the match.
  void add_hooks(MatchHooks& hooks);

  /// Starts the server, lets the sides join, plays to the end, and leaves no process running.
  void play(MatchObserver& observer);

  /// The whole result except files and times of the run.
  const MatchResult& result() const { return result_; }
  const Sides& sides() const { return sides_; }
  LoopTimes times() const { return loop_->times(); }

 private:
  void start_server();
  void join_sides();
  void shake_hands();
  void finish();
  void make_result();
  void add_sides();
  void blame_for_time();
  std::vector<AgentProgress> agent_progress() const;

  const MatchOptions& options_;
  std::uint64_t seed_;
  std::unique_ptr<Server> server_;
  Sides sides_;
  MatchGuard guard_;
  std::unique_ptr<MatchLoop> loop_;
  Hooks hooks_;
  std::vector<ProcessResult> processes_;
  MatchResult result_;
};

}  // namespace cls::match
