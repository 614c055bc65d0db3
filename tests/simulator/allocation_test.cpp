// The match server does not allocate memory after the start.
#include <gtest/gtest.h>

#include <cstdint>

#include "tests/support/allocation_count.h"
#include "tests/support/bare_server.h"

namespace cls::tests {
namespace {

using simulator::MatchConfig;

// With both logs, set plays, goals, say messages and the end of a half.
TEST(BareServer, AllocatesNothingAfterStart) {
  if (!counts_allocations()) GTEST_SKIP() << "sanitizers have an allocator of their own";
  constexpr int kStart = 100;
  MatchConfig config;
  config.seed = 3;
  config.server.auto_mode = true;
  config.server.kick_off_wait = 5;
  config.server.half_time = 150;  // seconds
  config.cycle_limit = 3000;
  BareServer match(config);
  std::int64_t allocations = 0;

  for (int cycle = 0; match.world().mode != soccer::PlayMode::kTimeOver; ++cycle) {
    const std::int64_t before = allocation_count();
    match.serve();
    if (cycle >= kStart) {
      EXPECT_EQ(allocation_count(), before)
          << "at " << match.world().clock.time << ',' << match.world().clock.stoppage << " in "
          << name(match.world().mode);
    }
    allocations += allocation_count() - before;
    match.act();
  }
  const auto& teams = match.world().teams;

  EXPECT_GT(teams[0].score + teams[1].score, 0);  // the match had events
  EXPECT_GT(allocations, 0);                      // allocations are counted
}

}  // namespace
}  // namespace cls::tests
