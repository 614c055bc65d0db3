// Commands that start a guard process.
#include "cli/application.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/support/command.h"
#include "tests/support/temporary_folder.h"

namespace cls::cli {
namespace {

using testing::HasSubstr;

bool guarded(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "cls");
  return may_start_programs(*command_tree(), static_cast<int>(arguments.size()), arguments.data());
}

TEST(EarlyGuard, StartsForCommandsThatStartPrograms) {
  EXPECT_TRUE(guarded({"match", "mock", "mock"}));
  EXPECT_TRUE(guarded({"--quiet", "match", "mock", "mock"}));
  EXPECT_TRUE(guarded({"doctor"}));
  EXPECT_TRUE(guarded({"server", "server::team_l_start=./start.sh"}));
  EXPECT_FALSE(guarded({"version"}));
  EXPECT_FALSE(guarded({"convert", "match", "x"}));
  EXPECT_FALSE(guarded({"--help"}));
  EXPECT_FALSE(guarded({}));
}

// The program loader needs the fourth descriptor, cls more.
TEST(EarlyGuard, ReportsWhyItCannotStart) {
  const tests::TemporaryFolder folder;
  const tests::CommandResult result = tests::run(
      {"/bin/sh", "-c",
       "exec 3>&-; ulimit -n 4; exec '" + tests::cls_binary().string() +
           "' match 'run:true --port {port}' mock --dir '" + (folder.path() / "m").string() + "'"});
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.err,
              HasSubstr("cls: ulimit -n 4 is too low: cls needs 32; raise it: ulimit -n 512\n"));
}

}  // namespace
}  // namespace cls::cli
