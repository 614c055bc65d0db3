// One of our teams on a soccer server over UDP, from its first message to its goodbye.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/match/options/server_command.h"
#include "orchestration/match/result/match_end.h"
#include "orchestration/match/result/match_observer.h"
#include "orchestration/match/sides/match_side.h"
#include "proxy/agent/team_driver.h"

namespace cls::orchestration::match {

/// Plays on its side's worker thread; the match's thread looks, and tells it when to stop.
class OwnTeam {
 public:
  enum class Stage {
    kIdle,
    kJoining,      ///< players ask the server to take part
    kIntroducing,  ///< they are on the pitch, and are made known to the Playmaker
    kPlaying,
    kOver,  ///< the team has left, whatever the reason; see end()
  };

  /// What a look at the match shows.
  struct Moment {
    MatchProgress progress;
    std::int64_t cycles_seen = 0;  ///< counts also cycles in which the clock stood
  };

  /// The error says that the server's host is not known. Nothing is sent yet. `options` must
  /// outlive the team. `cycle_limit` is for servers that know of none: the team plays up to that
  /// cycle, and stays silent in it.
  static base::Result<std::unique_ptr<OwnTeam>> create(std::unique_ptr<MatchSide> side,
                                                       const std::string& server_host,
                                                       const ServerPorts& ports,
                                                       const MatchOptions& options,
                                                       std::optional<int> cycle_limit);
  /// Stops the team and waits until it has left: a second, should its Playmaker not react.
  ~OwnTeam();
  OwnTeam(const OwnTeam&) = delete;
  OwnTeam& operator=(const OwnTeam&) = delete;

  /// Joins, introduces and plays; returns at once.
  void start();
  /// Makes it come to an end soon: nothing is asked any more, and calls in flight are called back.
  void stop();
  bool wait_over(std::chrono::milliseconds limit) { return side_->worker().wait_for(limit); }

  Stage stage() const { return stage_.load(); }
  Moment moment() const;
  /// Why it stopped by itself before the match was over; nothing while it plays, and when it was
  /// told to stop, reached the cycle limit, or saw the match end.
  std::optional<MatchEnd> end() const;
  bool reached_cycle_limit() const { return reached_limit_.load(); }
  /// How the server lets time run; synch before it has told.
  MatchMode mode() const { return mode_.load(); }
  std::vector<std::string> take_warnings();

  MatchSide& side() { return *side_; }
  const MatchSide& side() const { return *side_; }
  /// "brain (localhost:50051)".
  std::string who() const;

 private:
  OwnTeam(std::unique_ptr<MatchSide> side, const MatchOptions& options,
          std::optional<int> cycle_limit)
      : side_(std::move(side)), options_(options), cycle_limit_(cycle_limit) {}

  void live();
  bool join();
  bool introduce();
  void play();
  bool look_and_go_on();
  void await_last_cycle();
  bool cycle_limit_near() const;
  void fail(EndReason reason, std::string message);

  std::unique_ptr<soccer::UdpClients> clients_;
  std::unique_ptr<MatchSide> side_;
  std::unique_ptr<proxy::TeamDriver> driver_;
  const MatchOptions& options_;
  std::optional<int> cycle_limit_;
  std::atomic<Stage> stage_{Stage::kIdle};
  std::atomic<bool> stop_{false};
  std::atomic<bool> reached_limit_{false};
  std::atomic<MatchMode> mode_{MatchMode::kSynch};
  bool limit_near_ = false;
  mutable std::mutex mutex_;  // of what follows
  Moment moment_;
  std::optional<MatchEnd> end_;
  std::vector<std::string> warnings_;
};

}  // namespace cls::orchestration::match
