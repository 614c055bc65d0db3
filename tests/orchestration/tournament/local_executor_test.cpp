// The executor of this host with programs that take the place of `cls`.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "orchestration/tournament/run/match_executor.h"
#include "orchestration/tournament/schedule/schedule.h"
#include "tests/orchestration/tournament/fake_executor.h"
#include "tests/support/temporary_folder.h"

namespace cls::orchestration::tournament {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// A match whose guard was killed cannot end its Playmakers.
TEST(LocalExecutor, EndsProcessesThatOutliveTheirMatch) {
  const cls::tests::TemporaryFolder folder;
  const fs::path program = folder.path() / "cls";
  std::ofstream(program) << "#!/bin/sh\n(trap '' TERM; sleep 1000) &\nkill -9 $$\n";
  fs::permissions(program, fs::perms::owner_all);
  TournamentConfig config = config_of(Format::kRoundRobin, 2);
  config.folder = folder.path();
  const auto executor = local_executor(config, folder.path(), program);
  ASSERT_TRUE(executor) << executor.error().message;
  const Assignment assignment{next_fixtures(config, {}).front(), 1};
  ASSERT_TRUE((*executor)->start({&assignment, 1}).ok());
  const auto finished = (*executor)->wait(20s);
  ASSERT_TRUE(finished) << finished.error().message;
  ASSERT_EQ(finished->size(), 1U);
  ASSERT_TRUE(finished->front().outcome);
  EXPECT_EQ(finished->front().outcome->message, "cls match was killed by SIGKILL");
}

}  // namespace
}  // namespace cls::orchestration::tournament
