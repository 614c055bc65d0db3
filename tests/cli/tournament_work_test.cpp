// `cls tournament work`: tasks that are killed, repeated and run concurrently.
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/marked_processes.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using json = base::Json;
using Arguments = std::vector<std::string>;

class TournamentWork : public testing::Test {
 protected:
  void SetUp() override { write_config(40); }

  void write_config(int cycles) const {
    std::ofstream(cup() / "cls.toml") << "[tournament]\ncycles = " << cycles
                                      << "\n[server]\nkick_off_wait = 2\n"
                                         "[teams.RED]\nendpoint = \"mock\"\n"
                                         "[teams.BLUE]\nendpoint = \"mock\"\n";
  }

  Arguments work(int index) const {
    return {cls_binary(), "tournament", "work", cup(), "--index", std::to_string(index)};
  }

  std::size_t entries(const char* folder) const {
    std::error_code code;
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(cup() / folder, code)) {
      count += !entry.path().empty();
    }
    return count;
  }

  void wait_until_playing() const {
    while (entries("unfinished") == 0) std::this_thread::sleep_for(5ms);
  }

  json result(int index) const {
    return json::parse(
        read_file(cup() / "results" / ("00000" + std::to_string(index) + ".1.json")));
  }

  void expect_whole(int index) const {
    const json outcome = result(index);
    EXPECT_EQ(outcome["end_reason"], "finished");
    const fs::path folder = cup() / outcome["folder"].get<std::string>();
    EXPECT_TRUE(fs::exists(folder / "match.rcg.gz")) << folder;
    EXPECT_EQ(entries("results"), 1u) << "no temporary file is left";
    EXPECT_EQ(entries("unfinished"), 0u);
  }

  fs::path cup() const { return folder_.path(); }

  TemporaryFolder folder_;
  const std::string mark_ = new_mark();
  const Arguments environment_ = {std::string(kMarkVariable) + "=" + mark_};
};

TEST_F(TournamentWork, StoresOneResultOfConcurrentRuns) {
  run(work(2));  // creates plan and schedule
  fs::remove_all(cup() / "results");
  Command first(work(1));
  Command second(work(1));
  const CommandResult one = first.finish();
  const CommandResult other = second.finish();
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(other.exit_code, 0) << other.err;
  EXPECT_EQ(one.out, other.out);
  expect_whole(1);
}

TEST_F(TournamentWork, LeavesNoFilesAfterSigterm) {
  write_config(100000);
  Command working(work(1), environment_);
  wait_until_playing();
  working.send_signal(SIGTERM);
  EXPECT_EQ(working.finish(10s).exit_code, 143);
  EXPECT_EQ(entries("results"), 0u);
  EXPECT_EQ(entries("unfinished"), 0u);
  EXPECT_TRUE(all_marked_gone(mark_, 3s));
}

TEST_F(TournamentWork, RepeatsAfterSigkillAndRemovesLeftovers) {
  run(work(2));
  fs::remove_all(cup() / "results");
  Command working(work(1), environment_);
  wait_until_playing();
  working.send_signal(SIGKILL);
  working.finish();
  EXPECT_TRUE(all_marked_gone(mark_, 3s));
  EXPECT_EQ(entries("results"), 0u);
  EXPECT_EQ(entries("unfinished"), 1u);
  EXPECT_EQ(run(work(1)).exit_code, 0);
  ASSERT_EQ(run({cls_binary(), "tournament", "run", cup()}).exit_code, 0);
  expect_whole(1);
}

// As when `work` publishes its folder at the moment at which `run` begins the same match.
TEST_F(TournamentWork, FolderIsKeptByARunThatDoesNotKnowItsResult) {
  ASSERT_EQ(run(work(1)).exit_code, 0);
  const fs::path log = cup() / result(1)["folder"].get<std::string>() / "match.rcg.gz";
  const auto written = fs::last_write_time(log);
  fs::remove_all(cup() / "results");
  ASSERT_EQ(run({cls_binary(), "tournament", "run", cup()}).exit_code, 0);
  ASSERT_TRUE(fs::exists(log));
  EXPECT_EQ(fs::last_write_time(log), written);
}

TEST_F(TournamentWork, ReplacesTheFolderOfAnInterruptedAttempt) {
  ASSERT_EQ(run(work(1)).exit_code, 0);
  const fs::path folder = cup() / result(1)["folder"].get<std::string>();
  json interrupted = json::parse(read_file(folder / "result.json"));
  interrupted["end_reason"] = "interrupted";
  std::ofstream(folder / "result.json") << interrupted;
  fs::remove(folder / "match.rcg.gz");
  fs::remove_all(cup() / "results");
  ASSERT_EQ(run(work(1)).exit_code, 0);
  ASSERT_EQ(run({cls_binary(), "tournament", "run", cup()}).exit_code, 0);
  EXPECT_EQ(cup() / result(1)["folder"].get<std::string>(), folder);
  expect_whole(1);
}

// A folder without a result may be that in which `run` plays the same attempt.
TEST_F(TournamentWork, LeavesTheFolderOfAMatchThatIsBeingPlayed) {
  ASSERT_EQ(run(work(1)).exit_code, 0);
  const fs::path folder = cup() / result(1)["folder"].get<std::string>();
  fs::remove(folder / "result.json");
  fs::remove_all(cup() / "results");
  ASSERT_EQ(run(work(1)).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "match.rcg.gz")) << "its process may still write there";
  const fs::path own = cup() / result(1)["folder"].get<std::string>();
  EXPECT_NE(own, folder);
  EXPECT_TRUE(fs::exists(own / "match.rcg.gz"));
  ASSERT_EQ(run({cls_binary(), "tournament", "run", cup()}).exit_code, 0);
  EXPECT_TRUE(fs::exists(own / "match.rcg.gz")) << "it counts";
  EXPECT_FALSE(fs::exists(folder)) << "it does not count";
}

TEST_F(TournamentWork, RunPlaysElsewhereThanAProcessThatHasCreatedTheFolder) {
  ASSERT_EQ(run(work(1)).exit_code, 0);
  fs::remove(cup() / result(1)["folder"].get<std::string>() / "result.json");
  fs::remove_all(cup() / "results");
  ASSERT_EQ(run({cls_binary(), "tournament", "run", cup()}).exit_code, 0);
  const CommandResult report =
      run({cls_binary(), "tournament", "report", cup(), "--format", "json"});
  const auto folder = json::parse(report.out)["matches"][0]["folder"].get<std::string>();
  EXPECT_TRUE(folder.starts_with("unfinished/")) << folder;
  EXPECT_TRUE(fs::exists(cup() / folder / "match.rcg.gz"));
}

TEST_F(TournamentWork, ReplacesInvalidResult) {
  fs::create_directories(cup() / "results");
  std::ofstream(cup() / "results/000001.1.json") << "{ half";
  EXPECT_EQ(run(work(1)).exit_code, 0);
  expect_whole(1);
}

}  // namespace
}  // namespace cls::tests
