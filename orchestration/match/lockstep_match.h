// The embedded server and two sides taking turns, cycle by cycle, until something ends the match.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/io/byte_sink.h"
#include "base/result.h"
#include "orchestration/match/deadline_watch.h"
#include "orchestration/match/hooks/match_chronicle.h"
#include "orchestration/match/hooks/match_director.h"
#include "orchestration/match/options/match_options.h"
#include "orchestration/match/result/match_observer.h"
#include "orchestration/match/result/match_result.h"
#include "orchestration/match/sides/foreign_guests.h"
#include "orchestration/match/sides/match_side.h"
#include "simulator/server/lockstep_server.h"

namespace cls::orchestration::match {

/// The configuration of the embedded server that the options ask for.
simulator::MatchConfig server_config(const MatchOptions& options, std::uint64_t seed);

/// One match in lockstep. Use: create, record, play once, then read result(). The two sides run on
/// threads of their own, the server on the caller's, never at the same time; so what happens
/// depends on seed, parameters and the Playmakers' answers only. Foreign teams play along over UDP:
/// what happens then depends on their commands too.
class LockstepMatch {
 public:
  /// Where a match's wall time went, in seconds.
  struct Times {
    double simulator = 0.0;  ///< server turns
    double sides = 0.0;      ///< waiting for both sides
    double play = 0.0;       ///< from the first step to the last
  };

  /// `host` starts the programs of `run:` and `team:` sides, with their logs in `folder`; nullptr
  /// when no side needs it. It must outlive the match.
  static base::Result<std::unique_ptr<LockstepMatch>> create(
      const MatchOptions& options, const TeamNames& names, std::uint64_t seed,
      const std::atomic<int>& stop_signal, process::ProcessHost* host = nullptr,
      const std::filesystem::path& folder = {});

  /// Logs to write; all must outlive the match.
  void record(base::ByteSink& game_log, base::ByteSink& text_log) {
    server_->record(&game_log, &text_log);
  }

  /// Lets `director` arrange and watch the match; several take their turns in this order. Before
  /// play(); it must outlive the match.
  void direct(MatchDirector& director);

  /// Connects, introduces, plays to the end and takes leave.
  void play(MatchObserver& observer, MatchChronicle& chronicle);

  /// All that the match itself knows; files and times of the run are the caller's to add.
  MatchResult result() const;

  const MatchSide& left() const { return *left_; }
  const MatchSide& right() const { return *right_; }
  const Times& times() const { return times_; }

 private:
  LockstepMatch(const MatchOptions& options, std::uint64_t seed,
                const std::atomic<int>& stop_signal)
      : options_(options), seed_(seed), watch_(options, stop_signal) {}

  void connect(MatchObserver& observer);
  void join_guests(const MatchSide& side, MatchObserver& observer);
  void introduce(MatchObserver& observer);
  void arrange();
  void open_to_monitors(MatchObserver& observer);
  void keep_pace(std::chrono::steady_clock::time_point start) const;
  void play_cycles(MatchObserver& observer, MatchChronicle& chronicle);
  void leave();

  /// Left, right, and the trainer if there is one.
  std::vector<MatchSide*> sides() const;
  void run_on_all(const std::function<void(MatchSide&)>& work);
  base::Result<void> connect(MatchSide& side);
  void cancel_calls();
  void wait_for(MatchSide& side);
  void wait_for_guests();
  void check_guests();
  void check_programs();
  void end_programs();
  void end(EndReason reason, std::string message, const MatchSide* at_fault = nullptr);
  bool ended() const { return end_reason_.has_value(); }
  void check_answers(const MatchSide& side);
  void pass_on_warnings(MatchObserver& observer);
  void report_expectations(MatchObserver& observer);
  void report_progress(MatchObserver& observer) const;
  int last_cycle() const;

  const MatchOptions& options_;
  std::uint64_t seed_;
  DeadlineWatch watch_;
  std::unique_ptr<simulator::LockstepServer> server_;
  std::unique_ptr<MatchSide> left_;
  std::unique_ptr<MatchSide> right_;
  std::unique_ptr<MatchSide> trainer_;     ///< null: none
  std::unique_ptr<ForeignGuests> guests_;  ///< null: both sides are ours
  int cycles_without_guests_ = 0;          ///< in a row, in which they did not answer
  std::vector<MatchDirector*> directors_;
  bool playing_ = false;
  std::optional<EndReason> end_reason_;
  std::string message_;
  std::optional<soccer::Side> fault_;
  std::optional<ProcessFailure> failure_;
  std::vector<ProcessResult> processes_;
  std::vector<std::string> warnings_;
  std::int64_t steps_ = 0;
  Times times_;
};

}  // namespace cls::orchestration::match
