// Tasks of Slurm until their matches have ended: lost and held ones, restarts, interrupts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>
#include <set>
#include <thread>

#include "tests/support/files.h"
#include "tests/tournament/slurm_executor_fixture.h"

namespace cls::tournament {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using namespace std::chrono_literals;

TEST_F(SlurmExecutorTest, AwaitsTasksThatSqueueNeverShowed) {
  start(2);
  const auto [job, task] = task_of(1);
  slurm_.set_state(job, 0, "");
  slurm_.set_state(job, 1, "");
  for (int round = 0; round < 60 && slurm_.calls("squeue").size() <= 3; ++round) {
    const auto none = executor_->wait(500ms);
    ASSERT_TRUE(none) << none.error().message;
    EXPECT_TRUE(none->empty());
  }
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

}  // namespace
}  // namespace cls::tournament
