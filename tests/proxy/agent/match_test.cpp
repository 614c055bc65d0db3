// Two cls teams on the embedded server, with mock Playmakers called directly and over gRPC.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/mock_match.h"

namespace cls::tests {
namespace {

constexpr int kSteps = 150;

std::string game_log(std::uint64_t seed, int threads, MockCalls calls = MockCalls::kDirect) {
  MockMatch match(seed, threads, calls);
  match.play(kSteps);
  return match.game_log();
}

TEST(Match, IsDeterministicWithOneAndTwoThreads) {
  const std::string log = game_log(7, 1);
  EXPECT_GT(log.size(), 50'000U);
  EXPECT_TRUE(game_log(7, 1) == log);
  EXPECT_TRUE(game_log(7, 2) == log);
  EXPECT_FALSE(game_log(8, 1) == log);
}

TEST(Match, IsTheSameWithDirectCallsAndOverGrpc) {
  const std::string log = game_log(7, 2, MockCalls::kDirect);
  EXPECT_TRUE(game_log(7, 1, MockCalls::kGrpcInProcess) == log);
  EXPECT_TRUE(game_log(7, 2, MockCalls::kGrpcInProcess) == log);
}

TEST(Match, RequestsEveryDecisionWithoutServerErrors) {
  MockMatch match(7, 2);
  match.play(kSteps);

  for (const int side : {0, 1}) {
    for (const auto& player : match.team(side).players()) {
      const proxy::AgentStatistics& statistics = player->statistics();
      EXPECT_EQ(statistics.decisions, kSteps);
      EXPECT_EQ(statistics.missed, 0);
      EXPECT_EQ(player->server().errors.unreadable, 0) << player->server().errors.first_unreadable;
      EXPECT_EQ(player->server().errors.errors, 0) << player->server().errors.first_error;
      EXPECT_EQ(match.server().missed_cycles(soccer::slot_of(
                    side == 0 ? soccer::Side::kLeft : soccer::Side::kRight, player->unum())),
                0);
    }
  }
}

}  // namespace
}  // namespace cls::tests
