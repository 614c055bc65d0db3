// One step from each recorded state of the real server must give its next recorded state.
#include "simulator/replay.h"

#include <gtest/gtest.h>

#include "tests/simulator/replayed_match.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

std::string report(const std::string& what, const Agreement& agreement) {
  std::string text = what + ": " + std::to_string(agreement.different) + " of " +
                     std::to_string(agreement.compared) + " differ";
  for (const std::string& where : agreement.first_differences) text += "\n    " + where;
  return text;
}

void expect_same(const ReplayResult& result, const std::string& what, int allowed = 0) {
  const Agreement& agreement = result.agreements.at(what);
  EXPECT_GT(agreement.compared, 0);
  EXPECT_LE(agreement.different, allowed) << report(what, agreement);
}

// All that is not a position or velocity.
void expect_same_game(const ReplayResult& result) {
  for (const char* what : {"mode", "clock", "score", "state", "counters", "body", "neck", "stamina",
                           "effort", "capacity", "roughly"}) {
    expect_same(result, what);
  }
  EXPECT_EQ(result.our_words, result.their_words);
}

// The whole match is not in the repository; its first 395 cycles are.
TEST(Replay, AgreesWithTheRealServerInAnExcerptWithoutNoise) {
  const ReplayResult result = replay(read_recorded_match(fixture("simulator/noise-free.rcg.gz"),
                                                         fixture("simulator/noise-free.rcl.gz")),
                                     Noise::kNone);
  EXPECT_EQ(result.agreements.at("ball").compared, 424);
  expect_same_game(result);
  expect_same(result, "ball");
  // A player cleared from the ball, and one in a central collision, magnify the record's rounding.
  expect_same(result, "player", 2);
}

TEST(Replay, AgreesWithTheRealServerInAMatchWithoutNoise) {
  const auto rcg = data("noise-free/game.rcg.gz");
  const auto rcl = data("noise-free/game.rcl.gz");
  if (!rcg || !rcl) GTEST_SKIP() << "no data: set CLS_DATA";
  const ReplayResult result = replay(read_recorded_match(*rcg, *rcl), Noise::kNone);
  EXPECT_EQ(result.agreements.at("ball").compared, 2158);
  expect_same_game(result);
  // 99.86 and 99.98 %: all that the rounding of the record allows (README of the data).
  expect_same(result, "ball", 3);
  expect_same(result, "player", 9);
}

/// Matches with default noise, one of them with extra time and a shoot-out.
class NoisyReplay : public ::testing::TestWithParam<const char*> {};

TEST_P(NoisyReplay, CallsWhatTheRealRefereeCalled) {
  const auto rcg = data(std::string(GetParam()) + ".rcg.gz");
  const auto rcl = data(std::string(GetParam()) + ".rcl.gz");
  if (!rcg || !rcl) GTEST_SKIP() << "no data: set CLS_DATA";
  const ReplayResult result = replay(read_recorded_match(*rcg, *rcl), Noise::kFromRecord);
  for (const char* what :
       {"mode", "clock", "score", "counters", "neck", "stamina", "effort", "capacity"}) {
    expect_same(result, what);
  }
  EXPECT_EQ(result.our_words, result.their_words);
}

INSTANTIATE_TEST_SUITE_P(Logs, NoisyReplay,
                         ::testing::Values("logs/helios-vs-helios-full",
                                           "logs/cyrus-vs-helios-full",
                                           "logs/extra-time-and-penalties",
                                           "logs/recorded-messages", "logs/rcg-v6",
                                           "aligned/game"));

}  // namespace
}  // namespace cls::tests
