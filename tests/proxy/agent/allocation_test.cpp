// Agents keep their memory from cycle to cycle.
#include <gtest/gtest.h>

#include <cstdint>

#include "tests/support/allocation_count.h"
#include "tests/support/mock_match.h"

namespace cls::tests {
namespace {

// Server, agents and mocks together. What is left are players and intercept plans that a State
// gains or loses, and replies that are larger than usual.
TEST(Match, AllocatesAtMostTwicePerAgentAndCycle) {
  if (!counts_allocations()) GTEST_SKIP() << "sanitizers have an allocator of their own";
  constexpr int kStart = 100;
  constexpr int kSteps = 300;
  constexpr int kAgents = 22;
  MockMatch match(7, 1);
  ASSERT_TRUE(match.play(kStart));
  const std::int64_t before = allocation_count();
  ASSERT_TRUE(match.play(kSteps));
  const std::int64_t allocations = allocation_count() - before;
  EXPECT_GT(allocations, 0);  // they are counted
  EXPECT_LE(allocations, 2 * kAgents * kSteps);
}

}  // namespace
}  // namespace cls::tests
