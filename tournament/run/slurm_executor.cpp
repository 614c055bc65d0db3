// Plays matches as tasks of Slurm job arrays.
//
// The tasks do not depend on this process: each plays its match with `cls tournament work` and
// writes a result file to the shared folder, which this executor collects. So this process may be
// killed; the next run finds its batches by their records (slurm_batch.h) and their jobs by name.
// squeue is polled only for tasks that ended without a result. Those are lost (node failure,
// scancel, time limit, ...), and their matches are returned to be played again. Slurm itself
// requeues a task whose node failed; if both run, the first result counts.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <fstream>
#include <map>
#include <set>
#include <thread>

#include "tournament/run/match_executor.h"
#include "tournament/run/slurm_batch.h"
#include "tournament/run/slurm_client.h"
#include "tournament/store/collector.h"
#include "tournament/store/folder.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double kDefaultPollIntervalS = 10.0;
// A result may appear in a shared folder a little later than squeue reports its task as ended.
constexpr int kPollsUntilLost = 2;
constexpr int kMaxLosses = 3;
// Bounds the share of time spent on polling, with many files or a busy controller.
constexpr double kPausePerDuration = 5.0;

/// The schedule of a periodic action; the pause grows with the duration of the action.
class Throttle {
 public:
  explicit Throttle(Seconds min_pause) : min_pause_(min_pause) {}

  bool due() const { return Clock::now() >= next_; }
  void begin() { began_ = Clock::now(); }
  void done() {
    const auto now = Clock::now();
    const Seconds took = now - began_;
    next_ = now + std::chrono::duration_cast<Clock::duration>(
                      std::max(min_pause_, Seconds(took.count() * kPausePerDuration)));
  }

 private:
  Seconds min_pause_;
  Clock::time_point began_;
  Clock::time_point next_ = Clock::now();
};

std::string last_line_of(const fs::path& file) {
  std::ifstream stream(file);
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

class SlurmExecutor : public MatchExecutor {
 public:
  SlurmExecutor(const TournamentConfig& config, const fs::path& folder, fs::path program,
                SlurmClient client, int array_size)
      : config_(config),
        folder_(fs::absolute(folder).lexically_normal()),
        program_(std::move(program)),
        client_(std::move(client)),
        array_size_(array_size),
        chunk_(array_size),
        next_number_(next_batch_number(folder_)),
        status_poll_(Seconds(config.execution.slurm_poll_s.value_or(kDefaultPollIntervalS))),
        submission_(Seconds(config.execution.slurm_poll_s.value_or(kDefaultPollIntervalS))),
        result_poll_(Seconds(
            std::min(1.0, config.execution.slurm_poll_s.value_or(kDefaultPollIntervalS) / 10))) {}

  // Many at a time, so that arrays are long. With limited concurrency the arrays run in sequence,
  // because Slurm applies the limit within one array only.
  int free_slots() const override {
    const int free = config_.execution.slurm_tasks - running();
    if (config_.execution.concurrency > 0) return running() == 0 ? free : 0;
    return 2 * free >= config_.execution.slurm_tasks ? free : 0;
  }

  int running() const override { return static_cast<int>(tasks_.size() + waiting_.size()); }

  Result<void> start(std::span<const Assignment> assignments) override {
    waiting_.insert(waiting_.end(), assignments.begin(), assignments.end());
    return submit();
  }

  Result<std::vector<int>> take_over(std::span<const ScheduledMatch> matches) override {
    std::vector<int> taken;
    for (SlurmBatch& batch : read_batches(folder_)) {
      std::size_t live = 0;
      for (std::size_t i = 0; i < batch.tasks.size(); ++i) {
        const auto [index, attempt] = batch.tasks[i];
        const ScheduledMatch* match = awaited_match(matches, index, attempt);
        if (match == nullptr) continue;
        tasks_.emplace(index, Task{{match->fixture, attempt}, batch.number, static_cast<int>(i)});
        taken.push_back(index);
        ++live;
      }

      if (live == 0) {
        remove_batch(folder_, batch);
        continue;
      }
      const int number = batch.number;
      batches_.emplace(number, Batch{std::move(batch), live});
    }

    if (!taken.empty()) {
      notes_.push_back(
          fmt::format("{} matches of an earlier run are still with Slurm", taken.size()));
    }
    return taken;
  }

  Result<std::vector<FinishedMatch>> wait(std::chrono::milliseconds limit) override {
    constexpr std::chrono::milliseconds kPollInterval{10};
    const auto end = Clock::now() + limit;
    while (true) {
      if (!waiting_.empty() && submission_.due()) {
        TRY(submit());
      }
      const bool polled = status_poll_.due() && !tasks_.empty() && poll_status();
      if (polled || result_poll_.due()) collect();
      if (polled) {
        TRY(return_lost());
      }
      if (!finished_.empty() || Clock::now() >= end) return std::exchange(finished_, {});
      std::this_thread::sleep_for(kPollInterval);
    }
  }

  void withdraw() override {
    return_waiting();
    if (std::exchange(withdrawn_, true)) return;
    for (const auto& [number, batch] : batches_) cancel(batch.batch, true);
  }

  // Tasks that shut down cleanly write no result; the next run collects any that come. If scancel
  // fails, the records stay and the next run takes the matches over.
  void interrupt() override {
    return_waiting();
    for (const auto& [number, batch] : batches_) {
      if (cancel(batch.batch, false)) remove_batch(folder_, batch.batch);
    }
    for (const auto& [index, task] : tasks_) finished_.push_back({index, std::nullopt});
    tasks_.clear();
    batches_.clear();
  }

  std::vector<std::string> take_notes() override { return std::exchange(notes_, {}); }

 private:
  struct Task {
    Assignment assignment;
    int batch = 0;
    int position = 0;     // in the array
    int polls_ended = 0;  // consecutive polls in which squeue did not show it as alive
    std::string state{};  // as squeue reported it last
  };
  struct Batch {
    SlurmBatch batch;
    std::size_t live = 0;   // tasks that have not ended
    bool submitted = true;  // known for certain
    bool accepted = false;  // by sbatch, in this run
    bool seen = false;      // in squeue
  };

  // Submits as much as the site accepts, in arrays as long as it accepts them.
  Result<void> submit() {
    using Status = Submission::Status;
    submission_.begin();
    while (!waiting_.empty()) {
      const std::size_t size = std::min(waiting_.size(), base::index(chunk_));
      TRY_INIT(
          const auto submission,
          submit_array({waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(size)}));

      if (submission.status == Status::kAccepted || submission.status == Status::kUnknown) {
        waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(size));
        chunk_ = std::min(array_size_, 2 * chunk_);
        if (submission.status == Status::kAccepted) continue;
        note_once("sbatch: " + submission.message);
      } else if (submission.status == Status::kLimitReached && size > 1) {
        chunk_ = static_cast<int>(size / 2);
        continue;
      } else if (submission.status == Status::kRefused) {
        return Error{"Slurm rejected the job: " + submission.message};
      } else {
        note_once(fmt::format("sbatch: {}; retrying every {} s", submission.message,
                              config_.execution.slurm_poll_s.value_or(kDefaultPollIntervalS)));
      }
      break;
    }

    submission_.done();
    return {};
  }

  Result<Submission> submit_array(const std::vector<Assignment>& assignments) {
    const SlurmBatch batch = make_batch(next_number_++, folder_, assignments);
    TRY(write_batch(folder_, batch, assignments, program_));
    Submission submission = client_.submit(sbatch_arguments(
        folder_, batch, config_.execution.slurm_options, config_.execution.concurrency));

    using Status = Submission::Status;
    if (submission.status != Status::kAccepted && submission.status != Status::kUnknown) {
      remove_batch(folder_, batch);
      return submission;
    }

    for (std::size_t i = 0; i < assignments.size(); ++i) {
      tasks_.emplace(assignments[i].fixture.index,
                     Task{assignments[i], batch.number, static_cast<int>(i)});
    }
    batches_.emplace(batch.number,
                     Batch{batch, assignments.size(), submission.status == Status::kAccepted,
                           submission.status == Status::kAccepted, false});
    return submission;
  }

  // Updates all tasks from squeue; false when that fails.
  bool poll_status() {
    status_poll_.begin();
    std::vector<std::string> names;
    for (const auto& [number, batch] : batches_) names.push_back(batch.batch.name);
    const auto states = client_.tasks(names);
    status_poll_.done();
    if (!states) {
      note_once(fmt::format("squeue: {}; results are still collected", states.error().message));
      return false;
    }

    for (const auto& [name, state] : *states) {
      for (auto& [number, batch] : batches_) batch.seen |= batch.batch.name == name.first;
    }
    for (auto& [index, task] : tasks_) {
      Batch& batch = batches_.at(task.batch);
      const auto found = states->find({batch.batch.name, task.position});
      if (found == states->end()) {
        if (is_unseen(batch)) continue;
        ++task.polls_ended;
        continue;
      }
      batch.submitted = true;
      task.state = found->second.state;
      task.polls_ended = may_still_run(found->second) ? 0 : task.polls_ended + 1;
      note_held(batch.batch, found->second);
    }
    return true;
  }

  // Slurm has accepted these tasks and does not show them: they may run all the same, on another
  // cluster. Their results are awaited.
  bool is_unseen(const Batch& batch) {
    if (!batch.accepted || batch.seen) return false;
    note_once(fmt::format(
        "{} was accepted, but squeue does not show it; its results are awaited. If it is on "
        "another cluster, name that in slurm_options: --clusters=NAME",
        batch.batch.name));
    return true;
  }

  void note_held(const SlurmBatch& batch, const TaskState& state) {
    if (state.reason.find("eld") == std::string::npos) return;  // JobHeldUser, requeued held
    note_once(fmt::format("tasks of {} are held ({}): scontrol release", batch.name, state.reason));
  }

  void collect() {
    result_poll_.begin();
    for (const WorkResultName& name : list_work_results(folder_)) {
      const auto found = tasks_.find(name.index);
      if (found == tasks_.end() || found->second.assignment.number != name.attempt) continue;
      auto outcome = read_work_result(folder_, found->second.assignment.fixture, name.attempt);
      if (!outcome) continue;
      if (outcome->played()) {
        std::error_code code;
        fs::remove(folder_ / log_of(found->second), code);
      }
      finished_.push_back({name.index, std::move(outcome)});
      settle(found);
    }
    result_poll_.done();
  }

  Result<void> return_lost() {
    for (auto at = tasks_.begin(); at != tasks_.end();) {
      const auto found = at++;
      const Task& task = found->second;
      if (task.polls_ended < kPollsUntilLost) continue;
      if (!withdrawn_) {
        TRY(count_loss(task));
      }
      finished_.push_back({found->first, std::nullopt});
      settle(found);
    }
    return {};
  }

  // Repeated losses of one match have a cause: a time limit, memory, a wrong path on the nodes.
  Result<void> count_loss(const Task& task) {
    const Batch& batch = batches_.at(task.batch);
    if (!batch.submitted) return {};
    const int index = task.assignment.fixture.index;
    const std::string state = task.state.empty() ? "unknown to squeue" : task.state;
    const std::string line = last_line_of(folder_ / log_of(task));
    const std::string problem =
        fmt::format("match {}: task {} of {} produced no result ({}){}", index, task.position,
                    batch.batch.name, state, line.empty() ? "" : ": " + line);
    if (++losses_[index] >= kMaxLosses) {
      return Error{fmt::format("{}; failed {} times; see {}", problem, kMaxLosses,
                               (folder_ / log_of(task)).string())};
    }
    notes_.push_back(problem + "; the match is rerun");
    return {};
  }

  void settle(std::map<int, Task>::iterator at) {
    const auto batch = batches_.find(at->second.batch);
    tasks_.erase(at);
    if (--batch->second.live > 0) return;
    // Requeued tasks whose first execution wrote the result after all.
    cancel(batch->second.batch, true);
    remove_batch(folder_, batch->second.batch);
    batches_.erase(batch);
  }

  void return_waiting() {
    for (const Assignment& one : waiting_) {
      finished_.push_back({one.fixture.index, std::nullopt});
    }
    waiting_.clear();
  }

  bool cancel(const SlurmBatch& batch, bool pending_only) {
    const auto cancelled = client_.cancel(batch.name, pending_only);
    if (!cancelled) note_once(fmt::format("scancel: {}", cancelled.error().message));
    return cancelled.ok();
  }

  fs::path log_of(const Task& task) const {
    return task_log(batches_.at(task.batch).batch, task.position);
  }

  void note_once(const std::string& note) {
    if (noted_.insert(note).second) notes_.push_back(note);
  }

  const TournamentConfig& config_;
  fs::path folder_;
  fs::path program_;
  SlurmClient client_;
  int array_size_;
  int chunk_;  // tasks of the next array: fewer after a limit was reached
  int next_number_;
  std::deque<Assignment> waiting_;  // not submitted yet
  std::map<int, Task> tasks_;       // by match
  std::map<int, Batch> batches_;    // by number
  std::map<int, int> losses_;       // by match
  std::vector<FinishedMatch> finished_;
  std::vector<std::string> notes_;
  std::set<std::string> noted_;
  Throttle status_poll_;
  Throttle submission_;
  Throttle result_poll_;
  bool withdrawn_ = false;
};

}  // namespace

Result<std::unique_ptr<MatchExecutor>> slurm_executor(const TournamentConfig& config,
                                                      const fs::path& folder,
                                                      const fs::path& program) {
  TRY_INIT(auto client, SlurmClient::create(clusters_of(config.execution.slurm_options)));
  const auto size = client.max_array_size();
  if (!size) return Error{"executor slurm: " + size.error().message};
  return std::unique_ptr<MatchExecutor>(
      std::make_unique<SlurmExecutor>(config, folder, program, std::move(client), *size));
}

}  // namespace cls::tournament
