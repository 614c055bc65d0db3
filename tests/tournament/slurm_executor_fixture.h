// The Slurm executor of a round robin of five teams, on fake Slurm programs.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/index.h"
#include "base/io/whole_file.h"
#include "league/schedule/schedule.h"
#include "tests/support/temporary_folder.h"
#include "tests/tournament/fake_executor.h"
#include "tests/tournament/fake_slurm.h"
#include "tournament/run/slurm_batch.h"
#include "tournament/run/tournament_run.h"
#include "tournament/store/collector.h"
#include "tournament/store/folder.h"
#include "tournament/store/match_document.h"

namespace cls::tournament {

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
    std::filesystem::create_directories(folder_.path() / kResultsFolder);
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
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (all.size() < count && std::chrono::steady_clock::now() < limit) {
      const auto finished = executor_->wait(std::chrono::milliseconds(50));
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
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (std::chrono::steady_clock::now() < limit) {
      const auto finished = executor_->wait(std::chrono::milliseconds(50));
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
      ASSERT_TRUE(executor_->wait(std::chrono::milliseconds(10)));
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
  std::vector<std::string> notes_;
  std::map<int, int> attempts_;
  bool lose_ = false;
};

}  // namespace cls::tournament
