// Tournaments on a real two-node Slurm. Skipped if slurm-wlm and munge are not installed.
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <thread>

#include "base/text/json.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tournament_outcome.h"
#include "tests/tournament/private_slurm.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using json = base::Json;
using tests::Command;
using tests::CommandResult;
using Arguments = std::vector<std::string>;

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
  static Arguments run_arguments(const fs::path& folder, int rounds, int cycles,
                                 const Arguments& more) {
    Arguments arguments = {tests::cls_binary(),
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
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  Arguments slurm_arguments(int rounds, int cycles) const {
    Arguments arguments =
        run_arguments(cup(), rounds, cycles, {"--executor", "slurm", "--slurm-poll", "1"});
    // Kill the tournament when this process ends, because it would wait for its Slurm forever.
    arguments.insert(arguments.begin(), {"setpriv", "--pdeathsig", "KILL"});
    return arguments;
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

  // A task that runs on a node, such as "17_3".
  std::string running_task(const std::string& node = "") const {
    const std::string line =
        slurm_->run({"squeue", "--noheader", "--array", "--states=RUNNING", "--format=%i",
                     node.empty() ? "--nodelist=cls0,cls1" : "--nodelist=" + node});
    return line.substr(0, line.find('\n'));
  }

  void expect_same_as_local(const CommandResult& played, int rounds, int cycles) const {
    ASSERT_EQ(played.exit_code, 0) << played.err << slurm_->logs();
    const json report = json::parse(played.out);
    EXPECT_TRUE(report["complete"].get<bool>());
    const tests::TemporaryFolder other;
    const CommandResult here =
        Command(run_arguments(other.path(), rounds, cycles, {})).finish(kLimit);
    ASSERT_EQ(here.exit_code, 0) << here.err;
    EXPECT_EQ(tests::outcome_of(report), tests::outcome_of(json::parse(here.out)));
    for (const json& match : report["matches"]) {
      EXPECT_TRUE(fs::exists(cup() / match["folder"].get<std::string>() / "match.rcg.gz"))
          << match.dump();
    }
  }

  fs::path cup() const { return folder_.path(); }

  tests::TemporaryFolder folder_;
  std::optional<PrivateSlurm> slurm_;
};

TEST_F(SlurmTest, CompletesTournamentAfterNodeDaemonIsKilled) {
  const int cycles = 300;
  Command playing(slurm_arguments(2, cycles), slurm_->environment());
  ASSERT_TRUE(wait_for(playing, [&] { return results() >= 1 && !running_task("cls1").empty(); }))
      << slurm_->logs();
  slurm_->kill_daemon(1);
  const CommandResult played = playing.finish(kLimit);
  expect_same_as_local(played, 2, cycles);
  // Tasks on the dead node may stay COMPLETING there.
  EXPECT_EQ(slurm_->run({"squeue", "--noheader", "--states=PENDING,RUNNING"}), "")
      << "no task is left";
}

TEST_F(SlurmTest, LosesNoMatchAfterScancelRequeueAndKill) {
  const int cycles = 200;
  Command playing(slurm_arguments(1, cycles), slurm_->environment());
  const auto seen = [&](const std::string& text) {
    return slurm_->run({"scontrol", "--oneliner", "show", "job"}).find(text) != std::string::npos;
  };

  // A task may end while it is being cancelled or requeued; then try the next one.
  ASSERT_TRUE(wait_for(playing, [&] {
    const std::string task = running_task();
    if (!task.empty()) slurm_->run({"scancel", task});
    return seen("JobState=CANCELLED");
  })) << slurm_->logs();
  ASSERT_TRUE(wait_for(playing, [&] {
    const std::string task = running_task();
    if (!task.empty()) slurm_->run({"scontrol", "requeue", task});
    return seen("Restarts=1");
  })) << slurm_->logs();

  playing.send_signal(SIGKILL);
  EXPECT_EQ(playing.finish().signal, SIGKILL);

  Command again(slurm_arguments(1, cycles), slurm_->environment());
  expect_same_as_local(again.finish(kLimit), 1, cycles);
}

TEST_F(SlurmTest, LeavesNoJobAfterInterrupt) {
  Command playing(slurm_arguments(3, 300), slurm_->environment());
  ASSERT_TRUE(wait_for(playing, [&] { return !running_task().empty(); })) << slurm_->logs();
  playing.send_signal(SIGINT);
  EXPECT_EQ(playing.finish(kLimit).exit_code, 130);
  const auto limit = std::chrono::steady_clock::now() + kLimit;
  while (slurm_->run({"squeue", "--noheader"}) != "") {
    ASSERT_LT(std::chrono::steady_clock::now(), limit) << "cancelled jobs do not end";
    std::this_thread::sleep_for(100ms);
  }
}

TEST_F(SlurmTest, CompletesTournamentAfterPowerCutsOfNodes) {
  if (std::getenv("CLS_FULL") == nullptr) GTEST_SKIP() << "takes a minute: CLS_FULL=1";
  const int cycles = 300;
  Command playing(slurm_arguments(3, cycles), slurm_->environment());
  for (const int node : {1, 0, 1}) {
    const std::string name = "cls" + std::to_string(node);
    const std::size_t before = results();
    ASSERT_TRUE(wait_for(playing, [&] {
      return results() > before && !running_task(name).empty();
    })) << slurm_->logs();
    slurm_->cut_power(node);
    slurm_->start_node(node);
  }

  expect_same_as_local(playing.finish(kLimit), 3, cycles);
}

}  // namespace
}  // namespace cls::tournament
