// The executor for Slurm against programs that only pretend: limits, losses, restarts.
#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>
#include <map>
#include <set>
#include <thread>

#include "base/io/whole_file.h"
#include "orchestration/tournament/run/slurm_batch.h"
#include "orchestration/tournament/run/slurm_client.h"
#include "orchestration/tournament/run/tournament_run.h"
#include "orchestration/tournament/schedule/schedule.h"
#include "orchestration/tournament/store/collector.h"
#include "orchestration/tournament/store/folder.h"
#include "orchestration/tournament/store/match_document.h"
#include "tests/orchestration/tournament/fake_slurm.h"
#include "tests/orchestration/tournament/played.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::orchestration::tournament {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Words = std::vector<std::string>;

class SlurmExecutorTest : public testing::Test {
 protected:
  SlurmExecutorTest() {
    config_ = config_of(Format::kRoundRobin, 5);
    config_.executor = ExecutorKind::kSlurm;
    config_.slurm_poll_s = 0.02;
  }

  // As `cls tournament run` does when it begins; what ran before is not told that it ends.
  void begin() {
    executor_.reset();
    auto made = make_executor(config_, folder_.path(), "/opt/cls");
    ASSERT_TRUE(made) << made.error().message;
    executor_ = *std::move(made);
  }

  // The first matches of the schedule, at their first attempts.
  std::vector<Assignment> assignments(int count) const {
    std::vector<Assignment> all;
    for (Fixture& fixture : next_fixtures(config_, {})) all.push_back({std::move(fixture), 1});
    all.resize(static_cast<std::size_t>(count));
    return all;
  }

  std::vector<ScheduledMatch> matches() const {
    std::vector<ScheduledMatch> all;
    for (Fixture& fixture : next_fixtures(config_, {})) all.push_back(planned(std::move(fixture)));
    return all;
  }

  void start(int count) {
    begin();
    const auto started = executor_->start(assignments(count));
    ASSERT_TRUE(started.ok()) << started.error().message;
  }

  // Where Slurm has a match: job and task.
  std::pair<std::string, int> place(int index) const {
    for (const SlurmBatch& batch : read_batches(folder_.path())) {
      for (std::size_t i = 0; i < batch.tasks.size(); ++i) {
        if (batch.tasks[i].index == index) return {batch.name, static_cast<int>(i)};
      }
    }
    return {"none", -1};
  }

  void set_state(int index, const std::string& state, const std::string& reason = "None") {
    const auto [job, task] = place(index);
    slurm_.set_state(job, task, state, reason);
  }

  // What a task does that plays its match to the end.
  void deliver(const Fixture& fixture, int attempt = 1) {
    fs::create_directories(folder_.path() / kResultsFolder);
    Outcome outcome = better_wins(fixture);
    outcome.attempts = attempt;
    ASSERT_TRUE(base::write_file(folder_.path() / result_file(fixture.index, attempt),
                                 outcome_document(fixture, outcome))
                    .ok());
  }
  void deliver(int index) { deliver(assignments(index).back().fixture); }

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
      for (const Finished& one : *finished) {
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
      for (const Finished& one : *finished) {
        Assignment again = assignments(one.index).back();
        again.number = ++attempts_[one.index] + 1;
        if (auto started = executor_->start({&again, 1}); !started) return started.error().message;
        lose_ ? set_state(one.index, "FAILED") : void();
      }
    }
    return "";
  }

  // Waits until squeue was asked `count` more times.
  void asked(std::size_t count) {
    const std::size_t before = slurm_.calls("squeue").size();
    while (slurm_.calls("squeue").size() < before + count) {
      ASSERT_TRUE(executor_->wait(10ms));
    }
  }

  bool noted(const std::string& words) const {
    for (const std::string& note : notes_) {
      if (note.find(words) != std::string::npos) return true;
    }
    return false;
  }

  tests::TemporaryFolder folder_;
  FakeSlurm slurm_;
  TournamentConfig config_;
  std::unique_ptr<MatchExecutor> executor_;
  Words notes_;
  std::map<int, int> attempts_;
  bool lose_ = false;
};

TEST_F(SlurmExecutorTest, AnArrayPlaysTheMatchesInOneJob) {
  config_.slurm_options = {"--partition=short", "--time=10"};
  start(3);
  EXPECT_EQ(executor_->running(), 3);
  const auto calls = slurm_.calls("sbatch");
  ASSERT_EQ(calls.size(), 1u);
  EXPECT_NE(calls[0].find(" --partition=short --time=10 "), std::string::npos) << calls[0];
  EXPECT_NE(calls[0].find(" --array=0-2 "), std::string::npos) << calls[0];
  EXPECT_NE(calls[0].find(" --requeue "), std::string::npos) << calls[0];
  const std::string script = tests::read_file(folder_.path() / "slurm/000001.sh");
  EXPECT_NE(script.find("\nset -- 1 1 2 1 3 1\n"), std::string::npos) << script;
  EXPECT_NE(script.find("exec /opt/cls tournament work " + folder_.path().string() +
                        " --index \"$1\" --attempt \"$2\" --schedule "),
            std::string::npos)
      << script;
  const auto fixture = read_fixture(folder_.path() / "slurm/000001.jsonl", 2);
  ASSERT_TRUE(fixture);
  EXPECT_EQ(*fixture, assignments(2).back().fixture);
  for (const int index : {2, 1, 3}) deliver(index);
  EXPECT_EQ(ended(3), (std::map<int, bool>{{1, true}, {2, true}, {3, true}}));
  EXPECT_EQ(executor_->running(), 0);
  EXPECT_TRUE(fs::is_empty(folder_.path() / "slurm")) << "nothing is left of the batch";
  EXPECT_TRUE(slurm_.calls("sacct").empty()) << "accounting is not everywhere";
}

TEST_F(SlurmExecutorTest, ArraysAboveTheSitesSizeAreSplit) {
  slurm_.set_max_array_size(4);
  start(10);
  const auto calls = slurm_.calls("sbatch");
  ASSERT_EQ(calls.size(), 3u);
  EXPECT_NE(calls[0].find("--array=0-3 "), std::string::npos);
  EXPECT_NE(calls[1].find("--array=0-3 "), std::string::npos);
  EXPECT_NE(calls[2].find("--array=0-1 "), std::string::npos);
  EXPECT_EQ(slurm_.count("PENDING"), 10);
  for (int index = 1; index <= 10; ++index) deliver(index);
  EXPECT_EQ(ended(10).size(), 10u);
}

TEST_F(SlurmExecutorTest, WhereArraysAreSmallerThanToldTheyAreHalved) {
  start(0);
  slurm_.set_max_array_size(3);
  const auto all = assignments(8);
  ASSERT_TRUE(executor_->start(all).ok());
  EXPECT_EQ(slurm_.count("PENDING"), 8);
}

TEST_F(SlurmExecutorTest, WhatTheSubmitLimitForbidsIsSubmittedLater) {
  slurm_.set_max_tasks(5);
  start(12);
  EXPECT_EQ(slurm_.count("PENDING"), 5);
  EXPECT_EQ(executor_->running(), 12);
  std::set<int> done;
  while (done.size() < 12) {
    for (const SlurmBatch& batch : read_batches(folder_.path())) {
      for (std::size_t i = 0; i < batch.tasks.size(); ++i) {
        if (done.contains(batch.tasks[i].index)) continue;
        deliver(batch.tasks[i].index);
        slurm_.set_state(batch.name, static_cast<int>(i), "COMPLETED");
      }
    }
    const auto finished = executor_->wait(50ms);
    ASSERT_TRUE(finished);
    for (const Finished& one : *finished) {
      EXPECT_TRUE(one.outcome);
      done.insert(one.index);
    }
    for (std::string& note : executor_->take_notes()) notes_.push_back(std::move(note));
    EXPECT_LE(slurm_.count("PENDING"), 5);
  }
  EXPECT_TRUE(noted("job submit limit")) << "people are told why it takes long";
}

TEST_F(SlurmExecutorTest, AMistakeInTheOptionsEndsTheTournament) {
  begin();
  slurm_.refuse({"sbatch: error: Batch job submission failed: Invalid partition name specified"});
  const auto started = executor_->start(assignments(3));
  ASSERT_FALSE(started.ok());
  EXPECT_EQ(started.error().message,
            "Slurm refuses the job: sbatch: error: Batch job submission failed: Invalid partition "
            "name specified");
  EXPECT_TRUE(read_batches(folder_.path()).empty());
}

TEST_F(SlurmExecutorTest, AControllerThatDoesNotAnswerIsWaitedFor) {
  begin();
  slurm_.set_down(true);
  ASSERT_TRUE(executor_->start(assignments(2)).ok());
  EXPECT_TRUE(executor_->wait(100ms));
  EXPECT_TRUE(slurm_.queue().empty());
  slurm_.set_down(false);
  while (slurm_.count("PENDING") < 2) ASSERT_TRUE(executor_->wait(10ms));
  slurm_.set_down(true);
  deliver(1);
  deliver(2);
  EXPECT_EQ(ended(2).size(), 2u) << "results are collected without it";
  EXPECT_TRUE(noted("Unable to contact slurm controller"));
}

TEST_F(SlurmExecutorTest, AnUnclearAnswerIsClearedUpByTheQueue) {
  begin();
  slurm_.refuse(Words(4, "sbatch: error: Socket timed out on send/recv operation"));
  ASSERT_TRUE(executor_->start(assignments(1)).ok());
  EXPECT_EQ(executor_->running(), 1);
  for (int time = 1; time <= 3; ++time) {
    EXPECT_EQ(ended(1), (std::map<int, bool>{{1, false}})) << "it was not submitted";
    Assignment again = assignments(1)[0];
    again.number = time + 1;
    ASSERT_TRUE(executor_->start({&again, 1}).ok());
  }
  EXPECT_FALSE(noted("left no result")) << "a submission that failed is no loss";
}

TEST_F(SlurmExecutorTest, ALostJobIsPlayedAgain) {
  start(3);
  deliver(1);
  EXPECT_EQ(ended(1), (std::map<int, bool>{{1, true}}));
  set_state(2, "");
  EXPECT_EQ(ended(1), (std::map<int, bool>{{2, false}}));
  EXPECT_TRUE(noted("match 2: task 1 of cls-"));
  EXPECT_TRUE(noted("it is played again"));
  EXPECT_EQ(executor_->running(), 1);
}

TEST_F(SlurmExecutorTest, AResultCountsThoughTheNodeFailed) {
  start(2);
  set_state(1, "NODE_FAIL");
  set_state(2, "NODE_FAIL");
  deliver(2);
  EXPECT_EQ(ended(2), (std::map<int, bool>{{1, false}, {2, true}}));
  EXPECT_TRUE(noted("(NODE_FAIL)"));
}

TEST_F(SlurmExecutorTest, ARequeuedTaskIsWaitedFor) {
  start(1);
  for (const char* state : {"RUNNING", "COMPLETING", "PENDING", "REQUEUED", "SUSPENDED"}) {
    set_state(1, state, "BeginTime");
    asked(3);
    EXPECT_EQ(executor_->running(), 1) << state;
  }
  deliver(1);
  EXPECT_EQ(ended(1), (std::map<int, bool>{{1, true}}));
  EXPECT_EQ(slurm_.count("CANCELLED"), 0) << "it had ended already";
}

TEST_F(SlurmExecutorTest, ARepetitionOfWhatIsDoneIsCancelled) {
  start(1);
  set_state(1, "PENDING", "BeginTime");
  deliver(1);
  EXPECT_EQ(ended(1), (std::map<int, bool>{{1, true}}));
  EXPECT_EQ(slurm_.count("CANCELLED"), 1);
}

TEST_F(SlurmExecutorTest, AHeldTaskIsTold) {
  start(1);
  set_state(1, "PENDING", "launch failed requeued held");
  asked(3);
  deliver(1);
  ended(1);
  EXPECT_TRUE(noted("are held (launch failed requeued held)"));
}

TEST_F(SlurmExecutorTest, WhatTheUserCancelsIsPlayedAgain) {
  start(4);
  set_state(1, "RUNNING");
  set_state(3, "CANCELLED");
  EXPECT_EQ(ended(1), (std::map<int, bool>{{3, false}}));
  EXPECT_TRUE(noted("left no result (CANCELLED); it is played again"));
  Assignment again = assignments(3).back();
  again.number = 2;
  ASSERT_TRUE(executor_->start({&again, 1}).ok());
  deliver(again.fixture, 1);
  asked(2);
  EXPECT_EQ(executor_->running(), 4) << "an old attempt's result is not the new one's";
  deliver(again.fixture, 2);
  EXPECT_EQ(ended(1), (std::map<int, bool>{{3, true}}));
}

TEST_F(SlurmExecutorTest, AMatchThatAlwaysEndsWithoutResultEndsTheTournament) {
  start(1);
  std::ofstream(folder_.path() / "slurm/000003-0.out") << "cls: /opt/cls: not found\n\n";
  set_state(1, "FAILED");
  lose_ = true;
  const std::string told = error();
  EXPECT_NE(told.find("match 1: task 0 of cls-"), std::string::npos) << told;
  EXPECT_NE(told.find("left no result (FAILED): cls: /opt/cls: not found, for the 3rd time; see " +
                      (folder_.path() / "slurm/000003-0.out").string()),
            std::string::npos)
      << told;
  EXPECT_EQ(slurm_.calls("sbatch").size(), 3u);
}

TEST_F(SlurmExecutorTest, AKilledCollectorIsFollowedByOneThatTakesOver) {
  start(4);
  deliver(1);
  EXPECT_EQ(ended(1).size(), 1u);
  begin();
  auto all = matches();
  all[0].outcome = score(1, 0);
  for (int i = 0; i < 4; ++i) all[static_cast<std::size_t>(i)].attempts = 1;
  const auto taken = executor_->take_over(all);
  ASSERT_TRUE(taken);
  EXPECT_EQ(*taken, (std::vector<int>{2, 3, 4}));
  EXPECT_EQ(executor_->running(), 3);
  deliver(2);
  deliver(4);
  set_state(3, "TIMEOUT");
  EXPECT_EQ(ended(3), (std::map<int, bool>{{2, true}, {3, false}, {4, true}}));
  EXPECT_EQ(slurm_.calls("sbatch").size(), 1u) << "nothing is submitted twice";
  EXPECT_TRUE(read_batches(folder_.path()).empty());
}

TEST_F(SlurmExecutorTest, ABatchThatNeverReachedSlurmIsPlayedAfterARestart) {
  const auto ones = assignments(2);
  const SlurmBatch batch = make_batch(1, folder_.path(), ones);
  ASSERT_TRUE(write_batch(folder_.path(), batch, ones, "/opt/cls").ok());
  begin();
  ASSERT_EQ(executor_->take_over(matches())->size(), 2u);
  EXPECT_EQ(ended(2), (std::map<int, bool>{{1, false}, {2, false}}));
}

TEST_F(SlurmExecutorTest, AnInterruptionCancelsEverything) {
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

TEST_F(SlurmExecutorTest, AnInterruptionThatSlurmDoesNotHearKeepsTheRecords) {
  start(2);
  slurm_.set_down(true);
  executor_->interrupt();
  EXPECT_EQ(ended(2), (std::map<int, bool>{{1, false}, {2, false}}));
  EXPECT_TRUE(noted("scancel: error: Unable to contact slurm controller"));
  begin();  // scontrol does not answer either
  EXPECT_EQ(executor_->take_over(matches())->size(), 2u);
}

TEST_F(SlurmExecutorTest, AStopLetsRunningMatchesEnd) {
  start(3);
  set_state(2, "RUNNING");
  executor_->withdraw();
  EXPECT_EQ(slurm_.count("CANCELLED"), 2);
  EXPECT_EQ(ended(2), (std::map<int, bool>{{1, false}, {3, false}}));
  EXPECT_EQ(executor_->running(), 1);
  deliver(2);
  EXPECT_EQ(ended(1), (std::map<int, bool>{{2, true}}));
  EXPECT_TRUE(notes_.empty()) << notes_[0];
}

TEST_F(SlurmExecutorTest, ConcurrencyHoldsByOneArrayAfterTheOther) {
  config_.concurrency = 2;
  config_.slurm_tasks = 4;
  begin();
  EXPECT_EQ(executor_->room(), 4);
  ASSERT_TRUE(executor_->start(assignments(4)).ok());
  EXPECT_NE(slurm_.calls("sbatch")[0].find("--array=0-3%2 "), std::string::npos);
  EXPECT_EQ(executor_->room(), 0);
  for (const int index : {1, 2, 3}) deliver(index);
  ended(3);
  EXPECT_EQ(executor_->room(), 0);
  deliver(4);
  ended(1);
  EXPECT_EQ(executor_->room(), 4);
}

TEST_F(SlurmExecutorTest, ARoomIsRefilledByTheHalf) {
  config_.slurm_tasks = 4;
  start(4);
  deliver(1);
  ended(1);
  EXPECT_EQ(executor_->room(), 0);
  deliver(2);
  ended(1);
  EXPECT_EQ(executor_->room(), 2);
}

// Plays whatever is in the records, as a cluster would, until the end of the scope.
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
          base::write_file(folder_ / result_file(task.index, task.attempt),
                           outcome_document(*fixture, outcome));
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

TEST_F(SlurmExecutorTest, ARoundFollowsFromTheResultsOfTheOneBefore) {
  config_ = config_of(Format::kKnockout, 8);
  config_.executor = ExecutorKind::kSlurm;
  config_.slurm_poll_s = 0.02;
  ASSERT_TRUE(prepare_folder(folder_.path(), config_).ok());
  fs::create_directories(folder_.path() / kResultsFolder);
  RunOptions options;
  options.folder = folder_.path();
  options.config = config_;
  TournamentObserver nobody;
  const std::atomic<int> no_signal{0};
  RunSummary summary;
  {
    Cluster cluster(folder_.path());
    const auto run = run_tournament(
        options,
        [&](const TournamentConfig& config) {
          return make_executor(config, folder_.path(), "/opt/cls");
        },
        nobody, no_signal);
    ASSERT_TRUE(run) << run.error().message;
    summary = *run;
  }
  EXPECT_EQ(summary.end, RunEnd::kComplete);
  EXPECT_EQ(ranking(config_, summary.matches).front(), "A");
  const auto unbroken = play_all(config_, better_wins);
  ASSERT_EQ(summary.matches.size(), unbroken.size());
  for (std::size_t i = 0; i < unbroken.size(); ++i) {
    EXPECT_EQ(summary.matches[i].fixture, unbroken[i].fixture);
  }
}

TEST(SlurmSubmission, IsToldByItsWords) {
  using End = Submission::End;
  const auto end = [](int code, const std::string& words) {
    return submission_from(code, {words}).end;
  };
  EXPECT_EQ(end(0, "17"), End::kAccepted);
  EXPECT_EQ(end(1, "sbatch: error: Batch job submission failed: Invalid job array specification"),
            End::kTooMuch);
  EXPECT_EQ(end(1, "sbatch: error: QOSMaxSubmitJobPerUserLimit"), End::kTooMuch);
  EXPECT_EQ(end(-1, "sbatch: error: Slurm temporarily unable to accept job, sleeping and retrying"),
            End::kTooMuch);
  EXPECT_EQ(end(1,
                "sbatch: error: Batch job submission failed: Unable to contact slurm controller "
                "(connect failure)"),
            End::kUnreachable);
  EXPECT_EQ(end(1,
                "sbatch: error: Batch job submission failed: Socket timed out on send/recv "
                "operation"),
            End::kUnknown);
  EXPECT_EQ(end(-1, "sbatch does not answer"), End::kUnknown);
  EXPECT_EQ(end(1, "sbatch: error: invalid partition specified: nope"), End::kRefused);
  EXPECT_EQ(end(127, ""), End::kRefused);
}

}  // namespace
}  // namespace cls::orchestration::tournament
