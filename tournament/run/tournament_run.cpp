// The loop over schedule, executor and store.
#include "tournament/run/tournament_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <climits>
#include <deque>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "base/text/counted.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "league/schedule/schedule.h"
#include "match/programs/team_sandbox.h"
#include "process/hook_runner.h"
#include "tournament/report/report_document.h"
#include "tournament/run/event_feed.h"
#include "tournament/store/collector.h"
#include "tournament/store/decide.h"
#include "tournament/store/event_file.h"
#include "tournament/store/folder.h"
#include "tournament/store/lost_store.h"
#include "tournament/store/match_attempt.h"
#include "tournament/store/match_document.h"
#include "tournament/store/pauses_file.h"
#include "tournament/store/store.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Json;
using base::Result;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPollInterval{200};

std::chrono::milliseconds hook_limit(const TournamentConfig& config) {
  if (!config.execution.hook_limit_s) return process::kHookLimit;
  return std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::duration<double>(*config.execution.hook_limit_s));
}

class TournamentRun {
 public:
  TournamentRun(const RunOptions& options, TournamentObserver& observer,
                const std::atomic<int>& stop_signal, Store store, EventFile events,
                std::unique_ptr<MatchExecutor> executor)
      : options_(options),
        config_(options.config),
        observer_(observer),
        stop_signal_(stop_signal),
        store_(std::move(store)),
        events_(std::move(events)),
        executor_(std::move(executor)),
        hooks_(options.folder, config_.execution.folder, hook_limit(config_)),
        feed_(config_, options.folder) {}

  Result<RunSummary> run() {
    TRY(play());
    summary_.progress = progress();
    matches_.resize(total());
    summary_.matches = std::move(matches_);
    return std::move(summary_);
  }

 private:
  // Any step may fail for good; then the run ends, and the next one resumes from the store.
  Result<void> play() {
    TRY(load());
    if (is_decided()) end(RunEnd::kDecided);

    while (!ending_) {
      TRY(schedule_matches());
      if (waiting_.empty() && executor_->running() == 0) break;
      TRY(start_matches());
      TRY(record_finished(kPollInterval));
      poll();
    }
    return shut_down();
  }

  Result<void> load() {
    TRY(store_.requeue(true));
    TRY_INIT(auto decided, decided_matches(options_.folder, store_));
    matches_ = std::move(decided);
    rebuilds_ = matches_.empty() && was_begun(options_.folder);
    if (rebuilds_) {
      found_ = find_attempts(options_.folder);
      TRY(check_lost_results(options_.folder, found_));
    }

    log_event("tournament_started", {{"folder", options_.folder.string()},
                                     {"scheduled", matches_.size()},
                                     {"done", std::ranges::count_if(matches_, [](const auto& m) {
                                        return m.outcome.has_value();
                                      })}});
    for (const ScheduledMatch& match : matches_) {
      if (match.outcome) count_done(match);
    }

    TRY(record_work_results());
    TRY_INIT(const auto running, executor_->take_over(matches_));
    return recover_results({running.begin(), running.end()});
  }

  // Records the result files of `work` that are not in the store.
  Result<void> record_work_results() {
    for (WorkResult& result : collect_work_results(options_.folder, matches_)) {
      TRY(record_outcome(result.index, std::move(result.outcome)));
    }
    return {};
  }

  // Records matches that ended together with an earlier run, and queues all others without an
  // outcome, except those of the numbers `running`.
  Result<void> recover_results(const std::set<int>& running = {}) {
    for (ScheduledMatch& match : matches_) {
      if (match.outcome || match.attempts <= match.settled) continue;
      if (running.contains(match.fixture.index)) continue;
      const auto recover = rebuilds_ ? read_again : recover_result;
      auto outcome = recover(config_, match.fixture, match.attempts, options_.folder);
      if (!outcome) continue;
      TRY(record_outcome(match.fixture.index, *std::move(outcome)));
    }

    for (const int number : award_withdrawn(matches_)) count_done(match_at(number));
    waiting_.clear();
    for (const ScheduledMatch& match : matches_) {
      const int index = match.fixture.index;
      if (!match.outcome && !running.contains(index) && allowed(index)) waiting_.push_back(index);
    }
    return {};
  }

  // Once all matches are done, schedules those that follow; they may have result files already.
  Result<void> schedule_matches() {
    std::size_t before = matches_.size() + 1;
    while (!ending_ && waiting_.empty() && executor_->running() == 0 && matches_.size() != before) {
      before = matches_.size();
      TRY(schedule_next());
    }

    if (std::exchange(rebuilds_, false)) {
      const std::string note =
          fmt::format("{} was missing or empty: {} read from {}/", kStoreFile,
                      base::counted(done_, "result was", "results were"), kMatchesFolder);
      observer_.on_note(note);
      log_event("note", {{"text", note}});
    }
    return {};
  }

  Result<void> schedule_next() {
    std::vector<Fixture> next =
        options_.next ? options_.next(matches_) : next_fixtures(config_.competition, matches_);
    if (next.empty()) return {};

    for (const Fixture& fixture : next) matches_.push_back(planned(fixture));
    TRY(write_schedule(options_.folder, matches_));
    TRY(store_.add(next));
    log_event("matches_scheduled", {{"first", next.front().index},
                                    {"last", next.back().index},
                                    {"scheduled", matches_.size()}});

    if (rebuilds_) TRY(set_attempts(next));
    TRY(record_work_results());
    return recover_results();
  }

  // The matches of a store that was lost get the attempts that their folders tell, and the seeds
  // that were decided.
  Result<void> set_attempts(const std::vector<Fixture>& fixtures) {
    TRY_INIT(auto decided, decided_matches(options_.folder, store_));
    matches_ = std::move(decided);
    for (const Fixture& fixture : fixtures) {
      ScheduledMatch& match = match_at(fixture.index);
      const int attempts = latest_attempt(config_, match.fixture, options_.folder, found_);
      for (int attempt = 1; attempt <= attempts; ++attempt) {
        TRY(store_.begin_attempts(std::vector{fixture.index}));
      }
      match.attempts = attempts;
      // It may have been played before the team left.
      if (attempts > 0 && is_by_withdrawal(match)) match.outcome.reset();
    }
    return {};
  }

  Result<void> start_matches() {
    TRY(follow_pauses());
    if (paused_) return {};

    std::vector<int> indices;
    for (int slots = executor_->free_slots(); slots > 0 && !waiting_.empty(); --slots) {
      indices.push_back(waiting_.front());
      waiting_.pop_front();
    }
    if (indices.empty()) return {};

    TRY_INIT(const auto attempts, store_.begin_attempts(indices));
    std::vector<Assignment> assignments;
    for (std::size_t i = 0; i < indices.size(); ++i) {
      match_at(indices[i]).attempts = attempts[i];
      assignments.push_back({match_at(indices[i]).fixture, attempts[i]});
      log_event("match_started", {{"match", indices[i]}, {"attempt", attempts[i]}});
    }
    return executor_->start(assignments);
  }

  // A technical time-out holds the matches that have not started.
  Result<void> follow_pauses() {
    TRY_INIT(const auto pauses, read_pauses(options_.folder));
    const bool paused = is_paused(pauses);
    if (paused && executor_->running() == 0) std::this_thread::sleep_for(kPollInterval);
    if (paused == paused_) return {};

    paused_ = paused;
    executor_->hold(paused);
    log_event(paused ? "paused" : "resumed", {{"reason", pauses.back().reason}});
    observer_.on_note(paused ? fmt::format("paused: {}; cls tournament resume {}",
                                           pauses.back().reason, options_.folder.string())
                             : "resumed");
    return {};
  }

  Result<void> record_finished(std::chrono::milliseconds limit) {
    TRY_INIT(auto finished, executor_->wait(limit));
    for (FinishedMatch& one : finished) {
      if (!one.outcome) {
        waiting_.push_front(one.index);
        continue;
      }
      TRY(record_outcome(one.index, *std::move(one.outcome)));
    }
    return {};
  }

  /// The consequence of an outcome.
  enum class Then { kGoOn, kPlayAgain, kStop };

  // Commits the outcome, then notifies all who want to know.
  Result<void> record_outcome(int index, Outcome outcome) {
    const Then then = apply_policy(outcome);
    TRY(store_.finish(index, outcome, then == Then::kGoOn));

    ScheduledMatch& match = match_at(index);
    match.settled = outcome.attempts;
    clean_up(config_, match.fixture, outcome, options_.folder);
    if (then == Then::kPlayAgain) {
      waiting_.push_front(index);
    } else {
      match.outcome = outcome;
      ++done_in_this_run_;
      count_done(match);
    }

    ScheduledMatch recorded = match;  // a match that is played again has no outcome
    recorded.outcome = std::move(outcome);
    if (!rebuilds_) notify(recorded, then);  // hooks had those of a lost store before
    if (then == Then::kStop) end(RunEnd::kFault, fault_text(recorded));
    if (!ending_ && is_decided()) end(RunEnd::kDecided);
    return {};
  }

  // The policy for invalid matches, which may change the outcome.
  Then apply_policy(Outcome& outcome) const {
    const Execution& execution = config_.execution;
    // This warning concerns the host; the preflight checks have reported it already.
    if (execution.executor == ExecutorKind::kLocal) {
      std::erase(outcome.warnings, missing_sandbox(match_options(config_.conditions)));
    }

    const bool failed = !outcome.counts();
    if (failed && execution.on_crash == OnCrash::kForfeit && outcome.fault) make_forfeit(outcome);
    if (!keeps_folder(config_, outcome)) outcome.folder.clear();

    if (failed && execution.on_crash == OnCrash::kStop) return Then::kStop;
    const bool again =
        failed && execution.on_crash == OnCrash::kRerun && outcome.attempts <= execution.max_reruns;
    return again ? Then::kPlayAgain : Then::kGoOn;
  }

  void notify(const ScheduledMatch& match, Then then) {
    const Json document = json_of(config_, match);
    log_event(
        "match_finished",
        {{"match", match.fixture.index}, {"again", then != Then::kGoOn}, {"result", document}});
    observer_.on_match(config_, match, progress());
    feed_.settle(matches_, match, hooks_);
    if (!config_.execution.on_match_finish.empty()) {
      hooks_.start({"on_match_finish",
                    config_.execution.on_match_finish,
                    base::json_line(document) + "\n",
                    {}});
    }
  }

  bool is_decided() const { return options_.decided && options_.decided(matches_); }

  // Counts incrementally: counting thousands of matches after each one would cost more than a
  // match.
  void count_done(const ScheduledMatch& match) {
    if (!allowed(match.fixture.index)) return;
    ++done_;
    invalid_ += match.outcome->invalid();
  }

  bool allowed(int index) const { return !options_.last_match || index <= *options_.last_match; }

  // Matches that this run plays or counts.
  std::size_t total() const {
    return std::min(matches_.size(), base::index(options_.last_match.value_or(INT_MAX)));
  }

  // A team that leaves when it is far behind does not get a better result by that.
  static void make_forfeit(Outcome& outcome) {
    int& lost = outcome.fault == soccer::Side::kLeft ? outcome.left_score : outcome.right_score;
    int& won = outcome.fault == soccer::Side::kLeft ? outcome.right_score : outcome.left_score;
    if (won - lost < kForfeitGoals) {
      lost = 0;
      won = kForfeitGoals;
    }
    outcome.forfeit = true;
    outcome.left_penalties.reset();
    outcome.right_penalties.reset();
  }

  std::string fault_text(const ScheduledMatch& match) const {
    const Outcome& outcome = *match.outcome;
    return fmt::format("match {} is invalid ({}){}{}", match.fixture.index,
                       name(outcome.end_reason),
                       outcome.message.empty() ? "" : ": " + outcome.message,
                       outcome.folder.empty()
                           ? ""
                           : fmt::format("; see {}", (options_.folder / outcome.folder).string()));
  }

  // Passes notes to the observer; checks for signals and a stop file.
  void poll() {
    for (const std::string& note : executor_->take_notes()) {
      observer_.on_note(note);
      log_event("note", {{"text", note}});
    }
    pass_on_events();
    observer_.on_progress(progress());

    std::error_code code;
    if (const int signal = stop_signal_; signal != 0 && !ending_) {
      summary_.signal = signal;
      end(RunEnd::kInterrupted);
    } else if (!ending_ && fs::exists(options_.folder / kStopFile, code)) {
      end(RunEnd::kStopRequested);
    }
  }

  void pass_on_events() {
    feed_.poll(matches_, hooks_);
    for (const std::string& line : hooks_.take_errors()) observer_.on_note(line);
  }

  void end(RunEnd why, std::string message = "") {
    ending_ = why;
    summary_.message = std::move(message);
  }

  Result<void> shut_down() {
    summary_.end = ending_.value_or(RunEnd::kComplete);
    TRY(end_matches());
    TRY(store_.requeue(false));
    if (summary_.end == RunEnd::kStopRequested) {
      std::error_code code;
      fs::remove(options_.folder / kStopFile, code);
    }
    clean_up_unfinished(matches_, options_.folder);

    const RunProgress now = progress();
    log_event("tournament_ended", {{"end", name(summary_.end)},
                                   {"scheduled", now.total},
                                   {"done", now.done},
                                   {"invalid", now.invalid}});
    finish_hooks();
    return {};
  }

  // Running matches are played to their end after a stop file, and interrupted otherwise.
  Result<void> end_matches() {
    const bool graceful = summary_.end == RunEnd::kStopRequested;
    while (executor_->running() > 0) {
      if (!graceful || stop_signal_ != 0) {
        executor_->interrupt();
      } else {
        executor_->withdraw();
      }
      TRY(record_finished(kPollInterval));
      pass_on_events();
      observer_.on_progress(progress());
    }
    return {};
  }

  void finish_hooks() {
    const bool over = summary_.end == RunEnd::kComplete || summary_.end == RunEnd::kDecided;
    if (over && !config_.execution.on_finish.empty()) {
      hooks_.start({"on_finish",
                    config_.execution.on_finish,
                    report_json(make_report(config_, matches_, options_.folder)),
                    {}});
    }
    for (const std::string& line : hooks_.finish(stop_signal_)) observer_.on_note(line);
  }

  // Nothing depends on the events: without them the run continues.
  void log_event(std::string_view type, const Json& fields) {
    const auto added = events_.add(type, fields);
    if (added || !summary_.write_error.empty()) return;
    summary_.write_error = added.error().message;
    observer_.on_note(summary_.write_error);
  }

  ScheduledMatch& match_at(int index) { return matches_[base::index(index) - 1]; }

  RunProgress progress() const {
    return {.total = static_cast<int>(total()),
            .done = done_,
            .invalid = invalid_,
            .running = executor_->running(),
            .done_in_this_run = done_in_this_run_,
            .seconds = std::chrono::duration<double>(Clock::now() - begin_).count()};
  }

  const RunOptions& options_;
  const TournamentConfig& config_;
  TournamentObserver& observer_;
  const std::atomic<int>& stop_signal_;
  Store store_;
  EventFile events_;
  std::unique_ptr<MatchExecutor> executor_;
  process::HookRunner hooks_;
  EventFeed feed_;
  std::vector<ScheduledMatch> matches_;
  std::deque<int> waiting_;
  std::optional<RunEnd> ending_;
  RunSummary summary_;
  bool rebuilds_ = false;  ///< the store was lost: results are read from folders
  FoundAttempts found_;    ///< those of a lost store
  bool paused_ = false;
  int done_ = 0;
  int invalid_ = 0;
  int done_in_this_run_ = 0;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace

Result<RunSummary> run_tournament(const RunOptions& options, const MakeExecutor& make,
                                  TournamentObserver& observer,
                                  const std::atomic<int>& stop_signal) {
  std::error_code code;
  fs::remove(options.folder / kStopFile, code);  // of an earlier run
  TRY_INIT(auto store, Store::open(options.folder / kStoreFile));
  TRY_INIT(auto events, EventFile::open(options.folder / kTournamentEvents));
  TRY_INIT(auto executor, make(options.config));

  TournamentRun run(options, observer, stop_signal, std::move(store), std::move(events),
                    std::move(executor));
  return run.run();
}

}  // namespace cls::tournament
