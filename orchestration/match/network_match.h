// A match over UDP: a soccer server as a process of its own or somewhere else, our teams and
// foreign ones.
#pragma once

#include <array>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/match/deadline_watch.h"
#include "orchestration/match/options/match_options.h"
#include "orchestration/match/options/server_command.h"
#include "orchestration/match/result/event_log.h"
#include "orchestration/match/result/match_end.h"
#include "orchestration/match/result/match_observer.h"
#include "orchestration/match/result/match_result.h"
#include "orchestration/match/server/game_log_follower.h"
#include "orchestration/match/server/server_output.h"
#include "orchestration/match/sides/foreign_team.h"
#include "orchestration/match/sides/own_team.h"
#include "orchestration/process/ports.h"
#include "orchestration/process/process_host.h"

namespace cls::orchestration::match {

/// Everything that a match over UDP will start, before it starts it: for --dry-run too.
struct NetworkPlan {
  std::string server_host = "127.0.0.1";
  ServerPorts ports;
  std::optional<process::CommandPlan> server;    ///< none: it runs already
  std::array<std::optional<TeamPlan>, 2> teams;  ///< of `team:` sides, left and right
  std::vector<process::ReservedPort> reserved;   ///< held for the server
};

/// Finds programs and folders and chooses ports. The error says what is missing. With a team whose
/// start script knows no ports the server gets 6000, 6001 and 6002.
base::Result<NetworkPlan> plan_network_match(const MatchOptions& options, const TeamNames& names,
                                             std::uint64_t seed,
                                             const std::filesystem::path& folder);

/// The first port of the plan that somebody has already, with its owner; empty when all are free.
std::string taken_port(const NetworkPlan& plan);

/// One match. Use: create, play once, then read result(). The match's thread starts and watches;
/// our teams live on threads of their own.
class NetworkMatch {
 public:
  /// Programs are started by `host`, which must outlive the match, as must the options.
  static base::Result<std::unique_ptr<NetworkMatch>> create(const MatchOptions& options,
                                                            const TeamNames& names,
                                                            std::uint64_t seed,
                                                            const std::atomic<int>& stop_signal,
                                                            process::ProcessHost& host,
                                                            const std::filesystem::path& folder);

  /// Starts everything in order, plays to the end, and leaves nothing running.
  void play(MatchObserver& observer);

  /// What came of it, from the server's own log where there is one. Tells what is odd about it.
  MatchResult result(MatchObserver& observer) const;

  /// Goals and play modes from the server's log, once the match is over.
  void write_events(EventLog& events, const MatchResult& result) const;

 private:
  /// A foreign agent that ended in play: before the match did, or because it did?
  struct Departure {
    const process::Child* agent = nullptr;
    int cycle = 0;
    DeadlineWatch::Clock::time_point at;
  };

  /// One of both teams is set.
  struct Side {
    std::unique_ptr<OwnTeam> own;
    std::unique_ptr<ForeignTeam> foreign;
    std::optional<Departure> departure;
    std::string name;                ///< that the team shall have
    bool name_is_asked_for = false;  ///< by the user, not made from the endpoint
    std::string endpoint;
  };

  NetworkMatch(const MatchOptions& options, std::uint64_t seed, const std::atomic<int>& stop_signal,
               process::ProcessHost& host, std::filesystem::path folder);

  void start_sides();
  void warn_of_deadline(MatchObserver& observer);
  void wait_for_playmakers(MatchObserver& observer);
  void start_server(MatchObserver& observer);
  void wait_for_address(MatchObserver& observer);
  void join(std::size_t index, MatchObserver& observer);
  void join_foreign(Side& side, MatchObserver& observer);
  void check_name(const Side& side, MatchObserver& observer);
  void introduce(MatchObserver& observer);
  void play_cycles(MatchObserver& observer);
  void finish_play();
  void end_server();
  void finish();
  void await_gone();

  /// False when the match ended first. `what` says what did not happen, should the start limit be
  /// reached.
  bool wait_until(const std::function<bool()>& reached, std::function<std::string()> what);
  void check();
  void check_server();
  void check_side(Side& side);
  void check_foreign(Side& side);
  bool left_before_the_end(const Side& side) const;
  void end_by_death(const Side& side, const process::Child& child, int cycle);
  std::chrono::milliseconds silent_time() const;
  void look(MatchObserver& observer);
  bool cycle_limit_reached() const;
  bool match_is_over() const;
  void end(EndReason reason, std::string message, const process::Child* failed = nullptr);
  soccer::Side side_of(const Side& side) const {
    if (&side != &sides_[0] && &side != &sides_[1]) return soccer::Side::kNeutral;
    return &side == &sides_[0] ? soccer::Side::kLeft : soccer::Side::kRight;
  }
  const Endpoint& endpoint_of(std::size_t index) const {
    return index == 0 ? options_.left : index == 1 ? options_.right : *options_.trainer;
  }
  bool ended() const { return end_.has_value(); }
  void tell_news(MatchObserver& observer);
  void warn(MatchObserver& observer, std::string line);
  int cycle_now() const;
  std::string team_name(std::size_t index) const;
  std::string name_hint(const Side& side) const;

  void read_log(MatchResult& result) const;
  void do_without_log(MatchResult& result, const std::string& why) const;
  void compare_with_own(MatchResult& result) const;
  void take_own_view(MatchResult& result) const;

  const MatchOptions& options_;
  std::uint64_t seed_;
  process::ProcessHost& host_;
  std::filesystem::path folder_;
  DeadlineWatch watch_;
  NetworkPlan plan_;
  ServerOutput output_;
  GameLogFollower log_;
  std::shared_ptr<process::Child> server_;
  std::vector<Side> sides_;  ///< left, right, and the trainer if there is one
  std::optional<MatchEnd> end_;
  std::function<std::string()> waiting_for_;
  std::optional<soccer::Side> fault_;
  bool playing_ = false;
  bool try_again_ = false;
  std::int64_t cycles_seen_ = 0;
  DeadlineWatch::Clock::time_point seen_at_;
  std::size_t departures_told_ = 0;
  std::vector<std::string> warnings_;
  std::vector<ProcessResult> processes_;
  DeadlineWatch::Clock::time_point first_cycle_;
  DeadlineWatch::Clock::time_point last_cycle_;
};

}  // namespace cls::orchestration::match
