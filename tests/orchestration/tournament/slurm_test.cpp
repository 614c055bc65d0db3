// Tournaments on a real Slurm of two nodes. Skipped where slurm-wlm and munge are not installed.
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "tests/orchestration/tournament/private_slurm.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tournament_outcome.h"

namespace cls::orchestration::tournament {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using nlohmann::json;
using tests::Command;
using tests::CommandResult;
using Words = std::vector<std::string>;

constexpr std::chrono::seconds kLimit{280};

class SlurmTest : public testing::Test {
 protected:
  void SetUp() override {
    const std::string missing = PrivateSlurm::missing();
    if (!missing.empty()) {
      ASSERT_EQ(std::getenv("CLS_NEED_SLURM"), nullptr) << "CI must have " << missing;
      GTEST_SKIP() << "no Slurm here (" << missing << "): install slurm-wlm and munge";
    }
    slurm_.emplace(4);
    ASSERT_TRUE(slurm_->wait_until_ready()) << slurm_->logs();
  }

  void TearDown() override {
    if (HasFailure() && slurm_) std::cerr << slurm_->logs();
  }

  // `cls tournament run` in `folder`: three teams, each pairing `rounds` times, short matches.
  static Words run_words(const fs::path& folder, int rounds, int cycles, const Words& more) {
    Words words = {tests::cls_binary(),
                   "tournament",
                   "run",
                   folder,
                   "--team",
                   "RED=mock",
                   "--team",
                   "BLUE=mock",
                   "--team",
                   "HOLD=mock:hold",
                   "--rounds",
                   std::to_string(rounds),
                   "--cycles",
                   std::to_string(cycles),
                   "--set",
                   "server::kick_off_wait=2",
                   "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  Words slurm_words(int rounds, int cycles) const {
    Words words = run_words(cup(), rounds, cycles, {"--executor", "slurm", "--slurm-poll", "1"});
    // Whatever ends this process ends the one that would wait for its Slurm, too.
    words.insert(words.begin(), {"setpriv", "--pdeathsig", "KILL"});
    return words;
  }

  std::size_t results() const {
    std::error_code code;
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(cup() / "results", code)) {
      count += entry.path().extension() == ".json";
    }
    return count;
  }

  // True when `done` became true before `running` ended.
  static bool wait_for(const Command& running, const std::function<bool()>& done) {
    const auto limit = std::chrono::steady_clock::now() + kLimit;
    while (!done()) {
      if (std::chrono::steady_clock::now() > limit) return false;
      if (::kill(running.pid(), 0) != 0) return false;
      std::this_thread::sleep_for(20ms);
    }
    return true;
  }

  // A task that runs on a node: "17_3", and its match folder's number.
  std::string running_task(const std::string& node = "") const {
    const std::string line =
        slurm_->ask({"squeue", "--noheader", "--array", "--states=RUNNING", "--format=%i",
                     node.empty() ? "--nodelist=cls0,cls1" : "--nodelist=" + node});
    return line.substr(0, line.find('\n'));
  }

  void expect_like_here(const CommandResult& played, int rounds, int cycles) const {
    ASSERT_EQ(played.exit_code, 0) << played.err << slurm_->logs();
    const json report = json::parse(played.out);
    EXPECT_TRUE(report["complete"]);
    const tests::TemporaryFolder other;
    const CommandResult here = Command(run_words(other.path(), rounds, cycles, {})).finish(kLimit);
    ASSERT_EQ(here.exit_code, 0) << here.err;
    EXPECT_EQ(tests::outcome_of(report), tests::outcome_of(json::parse(here.out)));
    for (const json& match : report["matches"]) {
      EXPECT_TRUE(fs::exists(cup() / match["folder"].get<std::string>() / "match.rcg")) << match;
    }
  }

  fs::path cup() const { return folder_.path(); }

  tests::TemporaryFolder folder_;
  std::optional<PrivateSlurm> slurm_;
};

TEST_F(SlurmTest, ANodesDaemonIsKilledAndTheTableIsComplete) {
  const int cycles = 300;
  Command playing(slurm_words(2, cycles), slurm_->environment());
  ASSERT_TRUE(wait_for(playing, [&] { return results() >= 1 && !running_task("cls1").empty(); }))
      << slurm_->logs();
  slurm_->kill_daemon(1);
  const CommandResult played = playing.finish(kLimit);
  expect_like_here(played, 2, cycles);
  // What ran on the dead node may be completing there for ever.
  EXPECT_EQ(slurm_->ask({"squeue", "--noheader", "--states=PENDING,RUNNING"}), "")
      << "no task is left";
}

TEST_F(SlurmTest, ScancelRequeueAndADeadCollectorLoseNothing) {
  const int cycles = 200;
  Command playing(slurm_words(1, cycles), slurm_->environment());
  const auto seen = [&](const std::string& words) {
    return slurm_->ask({"scontrol", "--oneliner", "show", "job"}).find(words) != std::string::npos;
  };
  // A task may end while it is being cancelled or requeued: then the next one.
  ASSERT_TRUE(wait_for(playing, [&] {
    const std::string task = running_task();
    if (!task.empty()) slurm_->ask({"scancel", task});
    return seen("JobState=CANCELLED");
  })) << slurm_->logs();
  ASSERT_TRUE(wait_for(playing, [&] {
    const std::string task = running_task();
    if (!task.empty()) slurm_->ask({"scontrol", "requeue", task});
    return seen("Restarts=1");
  })) << slurm_->logs();
  playing.send_signal(SIGKILL);
  EXPECT_EQ(playing.finish().signal, SIGKILL);
  Command again(slurm_words(1, cycles), slurm_->environment());
  expect_like_here(again.finish(kLimit), 1, cycles);
}

TEST_F(SlurmTest, AnInterruptionLeavesNoJob) {
  Command playing(slurm_words(3, 300), slurm_->environment());
  ASSERT_TRUE(wait_for(playing, [&] { return !running_task().empty(); })) << slurm_->logs();
  playing.send_signal(SIGINT);
  EXPECT_EQ(playing.finish(kLimit).exit_code, 130);
  const auto limit = std::chrono::steady_clock::now() + kLimit;
  while (slurm_->ask({"squeue", "--noheader"}) != "") {
    ASSERT_LT(std::chrono::steady_clock::now(), limit) << "cancelled jobs do not end";
    std::this_thread::sleep_for(100ms);
  }
}

TEST_F(SlurmTest, APowerCutOfANodeIsSurvived) {
  if (std::getenv("CLS_FULL") == nullptr) GTEST_SKIP() << "takes a minute: CLS_FULL=1";
  const int cycles = 300;
  Command playing(slurm_words(3, cycles), slurm_->environment());
  for (const int node : {1, 0, 1}) {
    const std::string name = "cls" + std::to_string(node);
    const std::size_t before = results();
    ASSERT_TRUE(wait_for(playing, [&] {
      return results() > before && !running_task(name).empty();
    })) << slurm_->logs();
    slurm_->cut_power(node);
    slurm_->start_node(node);
  }
  expect_like_here(playing.finish(kLimit), 3, cycles);
}

}  // namespace
}  // namespace cls::orchestration::tournament
