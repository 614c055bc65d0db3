// When a match in which nothing happens is a stall.
#include "match/match_limits.h"

#include <gtest/gtest.h>

#include <thread>

namespace cls::match {
namespace {

using soccer::PlayMode;

class MatchLimitsTest : public testing::Test {
 protected:
  MatchLimitsTest() {
    options_.stall_after_s = 0.01;
    options_.server.kick_off_wait = 500;
  }

  // The end after `steps` steps in `mode` at `cycle`, when the stall limit has passed.
  std::optional<EndReason> end_after(std::int64_t steps, int cycle, PlayMode mode) {
    limits_.follow({{.cycle = cycle, .mode = mode}, steps});
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return limits_.exceeded();
  }

  MatchOptions options_;
  std::atomic<int> signal_{0};
  MatchLimits limits_{options_, signal_};
};

TEST_F(MatchLimitsTest, AllowTheWaitsOfTheReferee) {
  EXPECT_FALSE(end_after(0, 0, PlayMode::kBeforeKickOff));
  EXPECT_FALSE(end_after(700, 0, PlayMode::kBeforeKickOff));
  EXPECT_FALSE(end_after(1400, 0, PlayMode::kKickOffLeft)) << "another mode";
  EXPECT_FALSE(end_after(2100, 1, PlayMode::kKickOffLeft)) << "the clock has moved";
  EXPECT_FALSE(end_after(2800, 1, PlayMode::kKickOffLeft));
}

TEST_F(MatchLimitsTest, EndAMatchWhoseClockStands) {
  EXPECT_FALSE(end_after(0, 7, PlayMode::kBeforeKickOff));
  EXPECT_EQ(end_after(701, 7, PlayMode::kBeforeKickOff), EndReason::kStalled);
  EXPECT_EQ(limits_.describe(EndReason::kStalled),
            "the game clock has stood still at cycle 7 in before_kick_off for 701 steps");
  options_.no_deadline = true;
  EXPECT_FALSE(end_after(701, 7, PlayMode::kBeforeKickOff));
}

TEST_F(MatchLimitsTest, DoNotTrustAWaitWithoutEnd) {
  options_.server.kick_off_wait = 1'000'000'000;
  EXPECT_FALSE(end_after(0, 0, PlayMode::kBeforeKickOff));
  EXPECT_FALSE(end_after(6200, 0, PlayMode::kBeforeKickOff));
  EXPECT_EQ(end_after(6201, 0, PlayMode::kBeforeKickOff), EndReason::kStalled);
}

// Ctrl-Z, and on after a while.
TEST_F(MatchLimitsTest, DoNotCountTheTimeInWhichClsStoodStill) {
  using Clock = MatchLimits::Clock;
  options_.stall_after_s = 1.0;
  options_.time_limit_s = 2.0;
  limits_.begin_cycle();
  EXPECT_EQ(limits_.skip_standstill(), Clock::duration::zero()) << "a moment";

  std::this_thread::sleep_for(std::chrono::milliseconds(3200));
  const auto gap = limits_.skip_standstill();
  EXPECT_GT(gap, std::chrono::seconds(3));
  EXPECT_EQ(limits_.stood_still(), gap);
  EXPECT_FALSE(limits_.exceeded());
  limits_.begin_cycle();
  EXPECT_EQ(limits_.stood_still(), Clock::duration::zero());
}

}  // namespace
}  // namespace cls::match
