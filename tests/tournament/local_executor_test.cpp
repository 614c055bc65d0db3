// The executor of this host with programs that take the place of `cls`.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "league/schedule/schedule.h"
#include "tests/support/temporary_folder.h"
#include "tests/tournament/fake_executor.h"
#include "tournament/run/match_executor.h"
#include "tournament/store/folder.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class LocalExecutor : public testing::Test {
 protected:
  // Plays match 1 with this script in the place of `cls`.
  Outcome play(const std::string& script) {
    const fs::path program = folder_.path() / "cls";
    std::ofstream(program) << "#!/bin/sh\n" << script;
    fs::permissions(program, fs::perms::owner_all);
    config_.execution.folder = folder_.path();
    const auto executor = local_executor(config_, folder_.path(), program);
    if (!executor) throw std::runtime_error(executor.error().message);
    const Assignment assignment{next_fixtures(config_.competition, {}).front(), 1};
    if (!(*executor)->start({&assignment, 1})) throw std::runtime_error("cannot start");
    return (*executor)->wait(20s)->at(0).outcome.value();
  }

  const cls::tests::TemporaryFolder folder_;
  TournamentConfig config_ = config_of(Format::kRoundRobin, 2);
};

// A match whose guard was killed cannot end its Playmakers.
TEST_F(LocalExecutor, EndsProcessesThatOutliveTheirMatch) {
  const Outcome outcome = play("(trap '' TERM; sleep 1000) &\nkill -9 $$\n");
  EXPECT_EQ(outcome.message, "cls match was killed by SIGKILL");
}

TEST_F(LocalExecutor, PlaysInAFolderOfItsOwnWhereAnotherProcessHasTheUsualOne) {
  const fs::path usual =
      folder_.path() / match_folder(config_, next_fixtures(config_.competition, {})[0], 1);
  const fs::path own = folder_.path() / unfinished_folder(1, 1, unfinished_label());
  fs::create_directories(usual);
  fs::create_directories(own);
  std::ofstream(usual / "match.rcg") << "of another process";
  std::ofstream(own / "match.rcg") << "of a killed process with this number";
  const Outcome outcome = play("kill -9 $$\n");

  EXPECT_EQ(folder_.path() / outcome.folder, own);
  EXPECT_FALSE(fs::exists(own / "match.rcg"));
  EXPECT_TRUE(fs::exists(usual / "match.rcg"));
}

}  // namespace
}  // namespace cls::tournament
