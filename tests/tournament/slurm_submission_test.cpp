// How matches become jobs of Slurm: arrays, limits, replies of sbatch.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/files.h"
#include "tests/tournament/slurm_executor_fixture.h"
#include "tournament/run/slurm_client.h"

namespace cls::tournament {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using namespace std::chrono_literals;

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
  slurm_.refuse(
      std::vector<std::string>(4, "sbatch: error: Socket timed out on send/recv operation"));
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
  using Options = std::vector<std::string>;
  for (const Options& options : {Options{"--clusters=far"}, Options{"-M", "far"},
                                 Options{"-Mfar", "--partition=a"}, Options{"--clusters", "far"}}) {
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
