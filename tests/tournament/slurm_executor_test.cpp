// The Slurm executor against fake Slurm programs: limits, lost tasks, restarts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>
#include <map>
#include <set>
#include <thread>

#include "base/io/whole_file.h"
#include "league/schedule/schedule.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/tournament/fake_executor.h"
#include "tests/tournament/fake_slurm.h"
#include "tournament/run/slurm_batch.h"
#include "tournament/run/slurm_client.h"
#include "tournament/run/tournament_run.h"
#include "tournament/store/collector.h"
#include "tournament/store/folder.h"
#include "tournament/store/match_document.h"

namespace cls::tournament {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Lines = std::vector<std::string>;

class SlurmExecutorTest : public testing::Test {
 protected:
  SlurmExecutorTest() {
    config_ = config_of(Format::kRoundRobin, 5);
    config_.execution.executor = ExecutorKind::kSlurm;
    config_.execution.slurm_poll_s = 0.02;
  }

  // Creates the executor as `cls tournament run` does; an earlier one is destroyed without notice.
  void begin() {
    executor_.reset();
    auto made = make_executor(config_, folder_.path(), "/opt/cls");
    ASSERT_TRUE(made) << made.error().message;
    executor_ = *std::move(made);
  }

  // The first matches of the schedule, at their first attempts.
  std::vector<Assignment> assignments(int count) const {
    std::vector<Assignment> all;
    for (Fixture& fixture : next_fixtures(config_.competition, {}))
      all.push_back({std::move(fixture), 1});
    all.resize(base::index(count));
    return all;
  }

  std::vector<ScheduledMatch> matches() const {
    std::vector<ScheduledMatch> all;
    for (Fixture& fixture : next_fixtures(config_.competition, {}))
      all.push_back(planned(std::move(fixture)));
    return all;
  }

  void start(int count) {
    begin();
    const auto started = executor_->start(assignments(count));
    ASSERT_TRUE(started.ok()) << started.error().message;
  }

  // Job and task of a match.
  std::pair<std::string, int> task_of(int index) const {
    for (const SlurmBatch& batch : read_batches(folder_.path())) {
      for (std::size_t i = 0; i < batch.tasks.size(); ++i) {
        if (batch.tasks[i].index == index) return {batch.name, static_cast<int>(i)};
      }
    }
    return {"none", -1};
  }

  void set_state(int index, const std::string& state, const std::string& reason = "None") {
    const auto [job, task] = task_of(index);
    slurm_.set_state(job, task, state, reason);
  }

  // Writes the result file of a finished task.
  void write_result(const Fixture& fixture, int attempt = 1) {
    fs::create_directories(folder_.path() / kResultsFolder);
    Outcome outcome = better_wins(fixture);
    outcome.attempts = attempt;
    ASSERT_TRUE(base::write_file(folder_.path() / result_file(fixture.index, attempt),
                                 format_work_result(fixture, outcome))
                    .ok());
  }
  void write_result(int index) { write_result(assignments(index).back().fixture); }

  // Waits until `count` more matches have ended; by number, true: with an outcome.
  std::map<int, bool> ended(std::size_t count) {
    std::map<int, bool> all;
    const auto limit = std::chrono::steady_clock::now() + 60s;
    while (all.size() < count && std::chrono::steady_clock::now() < limit) {
      const auto finished = executor_->wait(50ms);
      if (!finished) {
        ADD_FAILURE() << finished.error().message;
        return all;
      }
      for (const FinishedMatch& one : *finished) {
        EXPECT_TRUE(all.emplace(one.index, one.outcome.has_value()).second) << "twice";
      }
      for (std::string& note : executor_->take_notes()) notes_.push_back(std::move(note));
    }
    return all;
  }

  // Waits for the error that ends a tournament.
  std::string error() {
    const auto limit = std::chrono::steady_clock::now() + 60s;
    while (std::chrono::steady_clock::now() < limit) {
      const auto finished = executor_->wait(50ms);
      if (!finished) return finished.error().message;
      for (const FinishedMatch& one : *finished) {
        Assignment again = assignments(one.index).back();
        again.number = ++attempts_[one.index] + 1;
        if (auto started = executor_->start({&again, 1}); !started) return started.error().message;
        lose_ ? set_state(one.index, "FAILED") : void();
      }
    }
    return "";
  }

  // Waits for `count` more calls of squeue.
  void wait_for_polls(std::size_t count) {
    const std::size_t before = slurm_.calls("squeue").size();
    while (slurm_.calls("squeue").size() < before + count) {
      ASSERT_TRUE(executor_->wait(10ms));
    }
  }

  bool noted(const std::string& text) const {
    for (const std::string& note : notes_) {
      if (note.find(text) != std::string::npos) return true;
    }
    return false;
  }

  tests::TemporaryFolder folder_;
  FakeSlurm slurm_;
  TournamentConfig config_;
  std::unique_ptr<MatchExecutor> executor_;
  Lines notes_;
  std::map<int, int> attempts_;
  bool lose_ = false;
};

TEST_F(SlurmExecutorTest, SubmitsMatchesAsOneJobArray) {
  config_.execution.slurm_options = {"--partition=short", "--time=10"};
  start(3);
  EXPECT_EQ(executor_->running(), 3);

  const auto calls = slurm_.calls("sbatch");
  ASSERT_EQ(calls.size(), 1u);
  EXPECT_THAT(calls[0], HasSubstr(" --partition=short --time=10 ")) << calls[0];
  EXPECT_THAT(calls[0], HasSubstr(" --array=0-2 ")) << calls[0];
  EXPECT_THAT(calls[0], HasSubstr(" --requeue ")) << calls[0];

  const std::string script = tests::read_file(folder_.path() / "slurm/000001.sh");
  EXPECT_THAT(script, HasSubstr("\nset -- 1 1 2 1 3 1\n"));
  EXPECT_THAT(script, HasSubstr("exec /opt/cls tournament work " + folder_.path().string() +
                                " --index \"$1\" --attempt \"$2\" --schedule "))
      << script;

  const auto fixture = read_fixture(folder_.path() / "slurm/000001.jsonl", 2);
  ASSERT_TRUE(fixture);
  EXPECT_EQ(*fixture, assignments(2).back().fixture);

  for (const int index : {2, 1, 3}) write_result(index);
  EXPECT_EQ(ended(3), (std::map<int, bool>{{1, true}, {2, true}, {3, true}}));
  EXPECT_EQ(executor_->running(), 0);
  EXPECT_TRUE(fs::is_empty(folder_.path() / "slurm")) << "the files of the batch are removed";
  EXPECT_TRUE(slurm_.calls("sacct").empty()) << "not every site has accounting";
}

TEST_F(SlurmExecutorTest, SplitsArraysAboveMaxArraySize) {
  slurm_.set_max_array_size(4);
  start(10);
  const auto calls = slurm_.calls("sbatch");
  ASSERT_EQ(calls.size(), 3u);
  EXPECT_THAT(calls[0], HasSubstr("--array=0-3 "));
  EXPECT_THAT(calls[1], HasSubstr("--array=0-3 "));
  EXPECT_THAT(calls[2], HasSubstr("--array=0-1 "));
  EXPECT_EQ(slurm_.count("PENDING"), 10);
  for (int index = 1; index <= 10; ++index) write_result(index);
  EXPECT_EQ(ended(10).size(), 10u);
}

TEST_F(SlurmExecutorTest, HalvesArraysThatSlurmRejects) {
  start(0);
  slurm_.set_max_array_size(3);
  const auto all = assignments(8);
  ASSERT_TRUE(executor_->start(all).ok());
  EXPECT_EQ(slurm_.count("PENDING"), 8);
}

TEST_F(SlurmExecutorTest, SubmitsRestAfterSubmitLimit) {
  slurm_.set_max_tasks(5);
  start(12);
  EXPECT_EQ(slurm_.count("PENDING"), 5);
  EXPECT_EQ(executor_->running(), 12);

  std::set<int> done;
  while (done.size() < 12) {
    for (const SlurmBatch& batch : read_batches(folder_.path())) {
      for (std::size_t i = 0; i < batch.tasks.size(); ++i) {
        if (done.contains(batch.tasks[i].index)) continue;
        write_result(batch.tasks[i].index);
        slurm_.set_state(batch.name, static_cast<int>(i), "COMPLETED");
      }
    }
    const auto finished = executor_->wait(50ms);
    ASSERT_TRUE(finished);
    for (const FinishedMatch& one : *finished) {
      EXPECT_TRUE(one.outcome);
      done.insert(one.index);
    }
    for (std::string& note : executor_->take_notes()) notes_.push_back(std::move(note));
    EXPECT_LE(slurm_.count("PENDING"), 5);
  }

  EXPECT_TRUE(noted("job submit limit")) << "reports why it takes long";
}

TEST_F(SlurmExecutorTest, FailsOnInvalidSbatchOptions) {
  begin();
  slurm_.refuse({"sbatch: error: Batch job submission failed: Invalid partition name specified"});
  const auto started = executor_->start(assignments(3));
  ASSERT_FALSE(started.ok());
  EXPECT_EQ(started.error().message,
            "Slurm rejected the job: sbatch: error: Batch job submission failed: Invalid partition "
            "name specified");
  EXPECT_TRUE(read_batches(folder_.path()).empty());
}

TEST_F(SlurmExecutorTest, RetriesWhileControllerIsUnreachable) {
  begin();
  slurm_.set_down(true);
  ASSERT_TRUE(executor_->start(assignments(2)).ok());
  EXPECT_TRUE(executor_->wait(100ms));
  EXPECT_TRUE(slurm_.queue().empty());

  slurm_.set_down(false);
  while (slurm_.count("PENDING") < 2) ASSERT_TRUE(executor_->wait(10ms));
  slurm_.set_down(true);
  write_result(1);
  write_result(2);

  EXPECT_EQ(ended(2).size(), 2u) << "results are collected while it is down";
  EXPECT_TRUE(noted("Unable to contact slurm controller"));
}

TEST_F(SlurmExecutorTest, PollsSqueueAfterUnclearReply) {
  begin();
  slurm_.refuse(Lines(4, "sbatch: error: Socket timed out on send/recv operation"));
  ASSERT_TRUE(executor_->start(assignments(1)).ok());
  EXPECT_EQ(executor_->running(), 1);

  for (int time = 1; time <= 3; ++time) {
    EXPECT_EQ(ended(1), (std::map<int, bool>{{1, false}})) << "it was not submitted";
    Assignment again = assignments(1)[0];
    again.number = time + 1;
    ASSERT_TRUE(executor_->start({&again, 1}).ok());
  }

  EXPECT_FALSE(noted("produced no result")) << "a failed submission is not a loss";
}

// Jobs on another cluster: squeue and scancel ask that one.
TEST_F(SlurmExecutorTest, AsksTheClustersOfItsOptions) {
  EXPECT_EQ(clusters_of({"--partition=a"}), "");
  for (const Lines& options : {Lines{"--clusters=far"}, Lines{"-M", "far"},
                               Lines{"-Mfar", "--partition=a"}, Lines{"--clusters", "far"}}) {
    EXPECT_EQ(clusters_of(options), "far");
  }
  ASSERT_EQ(setenv("SBATCH_CLUSTERS", "a,b", 1), 0);
  EXPECT_EQ(clusters_of({}), "a,b");
  EXPECT_EQ(clusters_of({"-Mfar"}), "far");
  unsetenv("SBATCH_CLUSTERS");

  config_.execution.slurm_options = {"--clusters=far"};
  start(1);
  (void)executor_->wait(100ms);
  executor_->interrupt();
  for (const char* program : {"sbatch", "squeue", "scancel"}) {
    ASSERT_FALSE(slurm_.calls(program).empty()) << program;
    EXPECT_THAT(slurm_.calls(program).back(), HasSubstr("--clusters=far")) << program;
  }
}

// A job that Slurm accepted is not submitted again because squeue looks elsewhere.
TEST_F(SlurmExecutorTest, AwaitsTasksThatSqueueNeverShowed) {
  start(2);
  const auto [job, task] = task_of(1);
  slurm_.set_state(job, 0, "");
  slurm_.set_state(job, 1, "");
  const auto none = executor_->wait(500ms);
  ASSERT_TRUE(none) << none.error().message;
  EXPECT_TRUE(none->empty());
  EXPECT_GT(slurm_.calls("squeue").size(), 3U);
  EXPECT_EQ(slurm_.calls("sbatch").size(), 1U);
  EXPECT_THAT(executor_->take_notes(),
              testing::Contains(HasSubstr("was accepted, but squeue does not show it")));

  write_result(1);
  write_result(2);
  EXPECT_EQ(ended(2), (std::map<int, bool>{{1, true}, {2, true}}));
}

TEST_F(SlurmExecutorTest, ReturnsMatchOfLostTask) {
  start(3);
  write_result(1);
  EXPECT_EQ(ended(1), (std::map<int, bool>{{1, true}}));
  set_state(2, "");
  EXPECT_EQ(ended(1), (std::map<int, bool>{{2, false}}));
  EXPECT_TRUE(noted("match 2: task 1 of cls-"));
  EXPECT_TRUE(noted("the match is rerun"));
  EXPECT_EQ(executor_->running(), 1);
}

TEST_F(SlurmExecutorTest, AcceptsResultOfFailedNode) {
  start(2);
  set_state(1, "NODE_FAIL");
  set_state(2, "NODE_FAIL");
  write_result(2);
  EXPECT_EQ(ended(2), (std::map<int, bool>{{1, false}, {2, true}}));
  EXPECT_TRUE(noted("(NODE_FAIL)"));
}

TEST_F(SlurmExecutorTest, WaitsForRequeuedTask) {
  start(1);
  for (const char* state : {"RUNNING", "COMPLETING", "PENDING", "REQUEUED", "SUSPENDED"}) {
    set_state(1, state, "BeginTime");
    wait_for_polls(3);
    EXPECT_EQ(executor_->running(), 1) << state;
  }
  write_result(1);
  EXPECT_EQ(ended(1), (std::map<int, bool>{{1, true}}));
  EXPECT_EQ(slurm_.count("CANCELLED"), 0) << "it had ended before";
}

TEST_F(SlurmExecutorTest, CancelsRequeuedTaskAfterItsResult) {
  start(1);
  set_state(1, "PENDING", "BeginTime");
  write_result(1);
  EXPECT_EQ(ended(1), (std::map<int, bool>{{1, true}}));
  EXPECT_EQ(slurm_.count("CANCELLED"), 1);
}

TEST_F(SlurmExecutorTest, ReportsHeldTasks) {
  start(1);
  set_state(1, "PENDING", "launch failed requeued held");
  wait_for_polls(3);
  write_result(1);
  ended(1);
  EXPECT_TRUE(noted("are held (launch failed requeued held)"));
}

TEST_F(SlurmExecutorTest, ReturnsMatchOfTaskCancelledByUser) {
  start(4);
  set_state(1, "RUNNING");
  set_state(3, "CANCELLED");
  EXPECT_EQ(ended(1), (std::map<int, bool>{{3, false}}));
  EXPECT_TRUE(noted("produced no result (CANCELLED); the match is rerun"));

  Assignment again = assignments(3).back();
  again.number = 2;
  ASSERT_TRUE(executor_->start({&again, 1}).ok());

  write_result(again.fixture, 1);
  wait_for_polls(2);
  EXPECT_EQ(executor_->running(), 4) << "the result of an earlier attempt does not count";

  write_result(again.fixture, 2);
  EXPECT_EQ(ended(1), (std::map<int, bool>{{3, true}}));
}

TEST_F(SlurmExecutorTest, FailsAfterThreeTasksWithoutResult) {
  start(1);
  std::ofstream(folder_.path() / "slurm/000003-0.out") << "cls: /opt/cls: not found\n\n";
  set_state(1, "FAILED");
  lose_ = true;
  const std::string message = error();

  EXPECT_THAT(message, HasSubstr("match 1: task 0 of cls-"));
  EXPECT_THAT(
      message,
      HasSubstr("produced no result (FAILED): cls: /opt/cls: not found; failed 3 times; see " +
                (folder_.path() / "slurm/000003-0.out").string()))
      << message;
  EXPECT_EQ(slurm_.calls("sbatch").size(), 3u);
}

TEST_F(SlurmExecutorTest, TakesOverBatchesAfterKill) {
  start(4);
  write_result(1);
  EXPECT_EQ(ended(1).size(), 1u);

  begin();
  auto all = matches();
  all[0].outcome = score(1, 0);
  for (int i = 0; i < 4; ++i) all[base::index(i)].attempts = 1;
  const auto taken_over = executor_->take_over(all);

  ASSERT_TRUE(taken_over);
  EXPECT_EQ(*taken_over, (std::vector<int>{2, 3, 4}));
  EXPECT_EQ(executor_->running(), 3);

  write_result(2);
  write_result(4);
  set_state(3, "TIMEOUT");
  EXPECT_EQ(ended(3), (std::map<int, bool>{{2, true}, {3, false}, {4, true}}));
  EXPECT_EQ(slurm_.calls("sbatch").size(), 1u) << "no match is submitted twice";
  EXPECT_TRUE(read_batches(folder_.path()).empty());
}

TEST_F(SlurmExecutorTest, ReturnsUnsubmittedBatchAfterRestart) {
  const auto batch_matches = assignments(2);
  const SlurmBatch batch = make_batch(1, folder_.path(), batch_matches);
  ASSERT_TRUE(write_batch(folder_.path(), batch, batch_matches, "/opt/cls").ok());
  begin();
  ASSERT_EQ(executor_->take_over(matches())->size(), 2u);
  EXPECT_EQ(ended(2), (std::map<int, bool>{{1, false}, {2, false}}));
}

TEST_F(SlurmExecutorTest, InterruptCancelsAllTasks) {
  slurm_.set_max_array_size(2);
  slurm_.set_max_tasks(4);
  start(6);
  set_state(1, "RUNNING");
  executor_->interrupt();
  EXPECT_EQ(slurm_.count("CANCELLED"), 4);
  EXPECT_EQ(ended(6).size(), 6u);
  EXPECT_EQ(executor_->running(), 0);
  EXPECT_TRUE(read_batches(folder_.path()).empty());
}

TEST_F(SlurmExecutorTest, InterruptKeepsRecordsWhenScancelFails) {
  start(2);
  slurm_.set_down(true);
  executor_->interrupt();
  EXPECT_EQ(ended(2), (std::map<int, bool>{{1, false}, {2, false}}));
  EXPECT_TRUE(noted("scancel: error: Unable to contact slurm controller"));
  begin();  // scontrol does not answer either
  EXPECT_EQ(executor_->take_over(matches())->size(), 2u);
}

TEST_F(SlurmExecutorTest, WithdrawLetsRunningMatchesFinish) {
  start(3);
  set_state(2, "RUNNING");
  executor_->withdraw();
  EXPECT_EQ(slurm_.count("CANCELLED"), 2);
  EXPECT_EQ(ended(2), (std::map<int, bool>{{1, false}, {3, false}}));
  EXPECT_EQ(executor_->running(), 1);
  write_result(2);
  EXPECT_EQ(ended(1), (std::map<int, bool>{{2, true}}));
  EXPECT_TRUE(notes_.empty()) << notes_[0];
}

TEST_F(SlurmExecutorTest, LimitedConcurrencyRunsArraysInSequence) {
  config_.execution.concurrency = 2;
  config_.execution.slurm_tasks = 4;
  begin();
  EXPECT_EQ(executor_->free_slots(), 4);
  ASSERT_TRUE(executor_->start(assignments(4)).ok());
  EXPECT_THAT(slurm_.calls("sbatch")[0], HasSubstr("--array=0-3%2 "));
  EXPECT_EQ(executor_->free_slots(), 0);

  for (const int index : {1, 2, 3}) write_result(index);
  ended(3);
  EXPECT_EQ(executor_->free_slots(), 0);

  write_result(4);
  ended(1);
  EXPECT_EQ(executor_->free_slots(), 4);
}

TEST_F(SlurmExecutorTest, RefillsWhenHalfOfTheTasksAreFree) {
  config_.execution.slurm_tasks = 4;
  start(4);
  write_result(1);
  ended(1);
  EXPECT_EQ(executor_->free_slots(), 0);
  write_result(2);
  ended(1);
  EXPECT_EQ(executor_->free_slots(), 2);
}

// Plays all recorded batches, as a cluster would, until the end of the scope.
class Cluster {
 public:
  explicit Cluster(fs::path folder) : folder_(std::move(folder)), thread_([this] { play(); }) {}
  ~Cluster() {
    over_ = true;
    thread_.join();
  }
  const std::vector<std::set<int>>& batches() const { return batches_; }

 private:
  void play() {
    std::set<int> known;
    while (!over_) {
      for (const SlurmBatch& batch : read_batches(folder_)) {
        if (!known.insert(batch.number).second) continue;
        std::set<int> rounds;
        for (const SlurmBatch::Task& task : batch.tasks) {
          const auto fixture =
              read_fixture(folder_ / kSlurmFolder / fmt_number(batch.number), task.index);
          if (!fixture) continue;
          rounds.insert(fixture->round);
          Outcome outcome = better_wins(*fixture);
          outcome.attempts = task.attempt;
          EXPECT_TRUE(base::write_file(folder_ / result_file(task.index, task.attempt),
                                       format_work_result(*fixture, outcome)));
        }
        batches_.push_back(rounds);
      }
      std::this_thread::sleep_for(2ms);
    }
  }
  static std::string fmt_number(int number) {
    std::string text = std::to_string(number);
    return std::string(6 - text.size(), '0') + text + ".jsonl";
  }

  fs::path folder_;
  std::atomic<bool> over_{false};
  std::vector<std::set<int>> batches_;
  std::thread thread_;
};

TEST_F(SlurmExecutorTest, SchedulesRoundFromResultsOfPreviousRound) {
  config_ = config_of(Format::kKnockout, 8);
  config_.execution.executor = ExecutorKind::kSlurm;
  config_.execution.slurm_poll_s = 0.02;
  ASSERT_TRUE(prepare_folder(folder_.path(), config_).ok());

  fs::create_directories(folder_.path() / kResultsFolder);
  RunOptions options;
  options.folder = folder_.path();
  options.config = config_;
  TournamentObserver observer;
  const std::atomic<int> no_signal{0};
  RunSummary summary;
  {
    Cluster cluster(folder_.path());
    const auto run = run_tournament(
        options,
        [&](const TournamentConfig& config) {
          return make_executor(config, folder_.path(), "/opt/cls");
        },
        observer, no_signal);
    ASSERT_TRUE(run) << run.error().message;
    summary = *run;
  }

  EXPECT_EQ(summary.end, RunEnd::kComplete);
  EXPECT_EQ(ranking(config_.competition, summary.matches).front(), "A");

  const auto uninterrupted = play_all(config_.competition, better_wins);
  ASSERT_EQ(summary.matches.size(), uninterrupted.size());

  for (std::size_t i = 0; i < uninterrupted.size(); ++i) {
    EXPECT_EQ(summary.matches[i].fixture, uninterrupted[i].fixture);
  }
}

TEST(SlurmSubmission, IsClassifiedByMessage) {
  using Status = Submission::Status;
  const auto end = [](int code, const std::string& text) {
    return parse_submission(code, {text}).status;
  };

  EXPECT_EQ(end(0, "17"), Status::kAccepted);
  EXPECT_EQ(end(1, "sbatch: error: Batch job submission failed: Invalid job array specification"),
            Status::kLimitReached);
  EXPECT_EQ(end(1, "sbatch: error: QOSMaxSubmitJobPerUserLimit"), Status::kLimitReached);
  EXPECT_EQ(end(-1, "sbatch: error: Slurm temporarily unable to accept job, sleeping and retrying"),
            Status::kLimitReached);
  EXPECT_EQ(end(1,
                "sbatch: error: Batch job submission failed: Unable to contact slurm controller "
                "(connect failure)"),
            Status::kUnreachable);
  EXPECT_EQ(end(1,
                "sbatch: error: Batch job submission failed: Socket timed out on send/recv "
                "operation"),
            Status::kUnknown);
  EXPECT_EQ(end(-1, "sbatch does not exit"), Status::kUnknown);
  EXPECT_EQ(end(1, "sbatch: error: invalid partition specified: nope"), Status::kRefused);
  EXPECT_EQ(end(127, ""), Status::kRefused);
}

}  // namespace
}  // namespace cls::tournament
