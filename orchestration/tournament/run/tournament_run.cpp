// The loop between store, schedule and executor.
#include "orchestration/tournament/run/tournament_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "orchestration/tournament/report/report_document.h"
#include "orchestration/tournament/run/hook.h"
#include "orchestration/tournament/schedule/schedule.h"
#include "orchestration/tournament/store/collector.h"
#include "orchestration/tournament/store/event_file.h"
#include "orchestration/tournament/store/folder.h"
#include "orchestration/tournament/store/match_attempt.h"
#include "orchestration/tournament/store/match_document.h"
#include "orchestration/tournament/store/store.h"

namespace cls::orchestration::tournament {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr int kForfeitGoals = 3;
constexpr std::chrono::milliseconds kLook{200};

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
        hooks_(options.folder) {}

  Result<RunSummary> run() {
    const auto done = play();
    if (!done) return done.error();
    summary_.progress = progress();
    summary_.matches = std::move(matches_);
    return std::move(summary_);
  }

 private:
  // Every step may fail for good; then the run ends and the next one goes on from the store.
  Result<void> play() {
    if (auto loaded = load(); !loaded) return loaded;
    if (options_.enough && options_.enough(matches_)) end(RunEnd::kDecided);
    while (!ending_) {
      if (auto drawn = draw_all(); !drawn) return drawn;
      if (waiting_.empty() && executor_->running() == 0) break;
      if (auto started = start_matches(); !started) return started;
      if (auto taken = take_finished(kLook); !taken) return taken;
      look_around();
    }
    return wind_up();
  }

  Result<void> load() {
    if (auto back = store_.put_back(true); !back) return back;
    auto stored = store_.matches();
    if (!stored) return stored.error();
    matches_ = *std::move(stored);
    if (auto told = tell("tournament_started",
                         {{"folder", options_.folder.string()},
                          {"scheduled", matches_.size()},
                          {"done", std::count_if(matches_.begin(), matches_.end(),
                                                 [](const auto& m) { return m.outcome; })}});
        !told) {
      return told;
    }
    for (const ScheduledMatch& match : matches_) {
      if (match.outcome) note_done(*match.outcome);
    }
    if (auto taken = take_up_results(); !taken) return taken;
    const auto elsewhere = executor_->take_over(matches_);
    if (!elsewhere) return elsewhere.error();
    return take_up_left_behind({elsewhere->begin(), elsewhere->end()});
  }

  // Outcomes of `work` that nobody committed.
  Result<void> take_up_results() {
    for (Delivery& delivery : collect_results(options_.folder, matches_)) {
      if (auto taken = take_outcome(delivery.index, std::move(delivery.outcome)); !taken) {
        return taken;
      }
    }
    return {};
  }

  // Those of matches that ended when cls did; what then is left waits to be played. `elsewhere`:
  // numbers of matches that are under way.
  Result<void> take_up_left_behind(const std::set<int>& elsewhere = {}) {
    for (ScheduledMatch& match : matches_) {
      if (match.outcome || match.attempts <= match.settled) continue;
      if (elsewhere.contains(match.fixture.index)) continue;
      auto outcome = left_behind(config_, match.fixture, match.attempts, options_.folder);
      if (!outcome) continue;
      if (auto taken = take_outcome(match.fixture.index, *std::move(outcome)); !taken) return taken;
    }
    waiting_.clear();
    for (const ScheduledMatch& match : matches_) {
      const int index = match.fixture.index;
      if (!match.outcome && !elsewhere.contains(index)) waiting_.push_back(index);
    }
    return {};
  }

  // When all are done, the matches that follow from them; those may be done already, too.
  Result<void> draw_all() {
    std::size_t before = matches_.size() + 1;
    while (!ending_ && waiting_.empty() && executor_->running() == 0 && matches_.size() != before) {
      before = matches_.size();
      if (auto drawn = draw(); !drawn) return drawn;
    }
    return {};
  }

  Result<void> draw() {
    std::vector<Fixture> next =
        options_.next ? options_.next(matches_) : next_fixtures(config_, matches_);
    if (next.empty()) return {};
    for (Fixture& fixture : next) {
      matches_.push_back(planned(fixture));
    }
    if (auto written = write_schedule(options_.folder, matches_); !written) return written;
    if (auto added = store_.add(next); !added) return added;
    if (auto told = tell("matches_scheduled", {{"first", next.front().index},
                                               {"last", next.back().index},
                                               {"scheduled", matches_.size()}});
        !told) {
      return told;
    }
    if (auto taken = take_up_results(); !taken) return taken;
    return take_up_left_behind();
  }

  Result<void> start_matches() {
    std::vector<int> indices;
    for (int room = executor_->room(); room > 0 && !waiting_.empty(); --room) {
      indices.push_back(waiting_.front());
      waiting_.pop_front();
    }
    if (indices.empty()) return {};
    const auto attempts = store_.begin_attempts(indices);
    if (!attempts) return attempts.error();
    std::vector<Assignment> assignments;
    for (std::size_t i = 0; i < indices.size(); ++i) {
      match_at(indices[i]).attempts = (*attempts)[i];
      assignments.push_back({match_at(indices[i]).fixture, (*attempts)[i]});
      if (auto told = tell("match_started", {{"match", indices[i]}, {"attempt", (*attempts)[i]}});
          !told) {
        return told;
      }
    }
    return executor_->start(assignments);
  }

  Result<void> take_finished(std::chrono::milliseconds limit) {
    auto finished = executor_->wait(limit);
    if (!finished) return finished.error();
    for (Finished& one : *finished) {
      if (!one.outcome) {
        waiting_.push_front(one.index);
        continue;
      }
      if (auto taken = take_outcome(one.index, *std::move(one.outcome)); !taken) return taken;
    }
    return {};
  }

  // The policy for invalid matches, the commit, and everybody who wants to know.
  Result<void> take_outcome(int index, Outcome outcome) {
    ScheduledMatch& match = match_at(index);
    const bool failed = outcome.end_reason != "finished" && !outcome.forfeit;
    bool again = false;
    if (failed && config_.on_crash == OnCrash::kForfeit && outcome.fault) make_forfeit(outcome);
    if (failed && config_.on_crash == OnCrash::kRerun)
      again = outcome.attempts <= config_.max_reruns;
    const bool stops = failed && config_.on_crash == OnCrash::kStop;
    if (!keeps_folder(config_, outcome)) outcome.folder.clear();
    if (auto kept = store_.finish(index, outcome, !again && !stops); !kept) return kept;
    match.settled = outcome.attempts;
    clean_up(config_, match.fixture, outcome, options_.folder);
    if (again) {
      waiting_.push_front(index);
    } else {
      match.outcome = outcome;
      ++done_in_this_run_;
      note_done(outcome);
    }
    ScheduledMatch told = match;
    told.outcome = std::move(outcome);
    const Json document = json_of(config_, told);
    if (auto written =
            tell("match_finished", {{"match", index}, {"again", again}, {"result", document}});
        !written) {
      return written;
    }
    observer_.on_match(config_, told, progress());
    if (!config_.on_match_finish.empty()) {
      hooks_.start("on_match_finish", config_.on_match_finish, document.dump() + "\n");
    }
    if (stops) end(RunEnd::kFault, fault_text(told));
    if (!ending_ && options_.enough && options_.enough(matches_)) end(RunEnd::kDecided);
    return {};
  }

  // Counted as they come: a look at all of many thousand after each would cost more than a match.
  void note_done(const Outcome& outcome) {
    ++done_;
    invalid_ += !outcome.counts();
  }

  static void make_forfeit(Outcome& outcome) {
    const bool left_lost = outcome.fault == soccer::Side::kLeft;
    outcome.forfeit = true;
    outcome.left_score = left_lost ? 0 : kForfeitGoals;
    outcome.right_score = left_lost ? kForfeitGoals : 0;
    outcome.left_penalties.reset();
    outcome.right_penalties.reset();
  }

  std::string fault_text(const ScheduledMatch& match) const {
    const Outcome& outcome = *match.outcome;
    return fmt::format("match {} is invalid ({}){}{}", match.fixture.index, outcome.end_reason,
                       outcome.message.empty() ? "" : ": " + outcome.message,
                       outcome.folder.empty()
                           ? ""
                           : fmt::format("; see {}", (options_.folder / outcome.folder).string()));
  }

  void look_around() {
    for (const std::string& note : executor_->take_notes()) {
      observer_.on_note(note);
      tell("note", {{"text", note}});
    }
    for (const std::string& line : hooks_.take_complaints()) observer_.on_note(line);
    observer_.on_progress(progress());
    std::error_code code;
    if (const int signal = stop_signal_; signal != 0 && !ending_) {
      summary_.signal = signal;
      end(RunEnd::kInterrupted);
    } else if (!ending_ && fs::exists(options_.folder / kStopFile, code)) {
      end(RunEnd::kStopRequested);
    }
  }

  void end(RunEnd why, std::string message = "") {
    ending_ = why;
    summary_.message = std::move(message);
  }

  // Matches under way: after a stop file they are played to their end, otherwise interrupted.
  Result<void> wind_up() {
    summary_.end = ending_.value_or(RunEnd::kComplete);
    const bool gently = summary_.end == RunEnd::kStopRequested;
    while (executor_->running() > 0) {
      if (!gently || stop_signal_ != 0) {
        executor_->interrupt();
      } else {
        executor_->withdraw();
      }
      if (auto taken = take_finished(kLook); !taken) return taken;
      observer_.on_progress(progress());
    }
    if (auto back = store_.put_back(false); !back) return back;
    if (summary_.end == RunEnd::kStopRequested) {
      std::error_code code;
      fs::remove(options_.folder / kStopFile, code);
    }
    const RunProgress now = progress();
    if (auto told = tell("tournament_ended", {{"end", name(summary_.end)},
                                              {"scheduled", now.total},
                                              {"done", now.done},
                                              {"invalid", now.invalid}});
        !told) {
      return told;
    }
    const bool over = summary_.end == RunEnd::kComplete || summary_.end == RunEnd::kDecided;
    if (over && !config_.on_finish.empty()) {
      hooks_.start("on_finish", config_.on_finish,
                   report_json(make_report(config_, matches_, options_.folder)));
    }
    for (const std::string& line : hooks_.take_complaints(true)) observer_.on_note(line);
    return {};
  }

  Result<void> tell(std::string_view type, const Json& fields) { return events_.add(type, fields); }

  ScheduledMatch& match_at(int index) { return matches_[static_cast<std::size_t>(index) - 1]; }

  RunProgress progress() const {
    RunProgress now;
    now.total = static_cast<int>(matches_.size());
    now.done = done_;
    now.invalid = invalid_;
    now.running = executor_->running();
    now.done_in_this_run = done_in_this_run_;
    now.seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    return now;
  }

  const RunOptions& options_;
  const TournamentConfig& config_;
  TournamentObserver& observer_;
  const std::atomic<int>& stop_signal_;
  Store store_;
  EventFile events_;
  std::unique_ptr<MatchExecutor> executor_;
  HookRunner hooks_;
  std::vector<ScheduledMatch> matches_;
  std::deque<int> waiting_;
  std::optional<RunEnd> ending_;
  RunSummary summary_;
  int done_ = 0;
  int invalid_ = 0;
  int done_in_this_run_ = 0;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace

std::string_view name(RunEnd end) {
  switch (end) {
    case RunEnd::kComplete:
      return "complete";
    case RunEnd::kDecided:
      return "decided";
    case RunEnd::kStopRequested:
      return "stopped";
    case RunEnd::kInterrupted:
      return "interrupted";
    case RunEnd::kFault:
      return "fault";
  }
  return "";
}

Result<RunSummary> run_tournament(const RunOptions& options, const MakeExecutor& make,
                                  TournamentObserver& observer,
                                  const std::atomic<int>& stop_signal) {
  std::error_code code;
  fs::remove(options.folder / kStopFile, code);  // meant for a run before this one
  auto store = Store::open(options.folder / kStoreFile);
  if (!store) return store.error();
  auto events = EventFile::open(options.folder / kTournamentEvents);
  if (!events) return events.error();
  auto executor = make(options.config);
  if (!executor) return executor.error();
  TournamentRun run(options, observer, stop_signal, *std::move(store), *std::move(events),
                    *std::move(executor));
  return run.run();
}

}  // namespace cls::orchestration::tournament
