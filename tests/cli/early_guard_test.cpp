// Commands that start a guard process.
#include "cli/support/early_guard.h"

#include <gtest/gtest.h>

#include <vector>

namespace cls::cli {
namespace {

bool guarded(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "cls");
  return may_start_programs(static_cast<int>(arguments.size()), arguments.data());
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

}  // namespace
}  // namespace cls::cli
