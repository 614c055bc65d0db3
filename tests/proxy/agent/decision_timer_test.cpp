// Due times: (think) in synchronous mode, see message or clock in real time.
#include "proxy/connection/decision_timer.h"

#include <gtest/gtest.h>

namespace cls::proxy {
namespace {

using soccer::ViewWidth;
using std::chrono::milliseconds;

const Instant kStart = Instant() + std::chrono::hours(1);
Instant at(int ms) { return kStart + milliseconds(ms); }

DecisionTimer real_time(bool synch_see = true) {
  DecisionTimer timer;
  timer.set_synchronous(false);
  timer.set_synch_see(synch_see);
  return timer;
}

TEST(DecisionTimer, WaitsForThinkInSynchronousMode) {
  DecisionTimer timer;
  timer.set_synchronous(true);
  timer.on_sense_body(at(0), ViewWidth::kNormal);
  timer.on_see(at(0));
  EXPECT_FALSE(timer.due(at(90)));
  EXPECT_EQ(timer.due_at(), Instant::max());
  timer.on_think(at(91));
  EXPECT_TRUE(timer.due(at(91)));
  timer.decided();
  EXPECT_FALSE(timer.due(at(92)));
}

TEST(DecisionTimer, NeedsNoClockInLockstep) {
  DecisionTimer timer;
  timer.on_sense_body({}, ViewWidth::kNormal);
  EXPECT_FALSE(timer.due({}));
  timer.on_think({});
  EXPECT_TRUE(timer.due({}));
}

TEST(DecisionTimer, DecidesOnSeeInRealTime) {
  DecisionTimer timer = real_time();
  timer.on_sense_body(at(0), ViewWidth::kNormal);
  EXPECT_FALSE(timer.due(at(29)));
  timer.on_see(at(3));
  EXPECT_TRUE(timer.due(at(3)));
  EXPECT_EQ(timer.due_at(), at(3));
}

TEST(DecisionTimer, WaitsThirtyMillisecondsForDueSee) {
  DecisionTimer timer = real_time();
  timer.on_sense_body(at(0), ViewWidth::kNormal);
  EXPECT_EQ(timer.due_at(), at(30));
  EXPECT_FALSE(timer.due(at(29)));
  EXPECT_TRUE(timer.due(at(30)));
}

TEST(DecisionTimer, WaitsLongerWithoutSynchronousSee) {
  DecisionTimer timer = real_time(false);
  timer.on_sense_body(at(0), ViewWidth::kNormal);
  timer.on_see(at(10));
  timer.decided();
  timer.on_sense_body(at(100), ViewWidth::kNormal);
  EXPECT_EQ(timer.due_at(), at(175));
}

TEST(DecisionTimer, DoesNotWaitWhenViewWidthExcludesSee) {
  const std::pair<ViewWidth, int> periods[] = {
      {ViewWidth::kNarrow, 1}, {ViewWidth::kNormal, 2}, {ViewWidth::kWide, 3}};

  for (const auto& [width, period] : periods) {
    DecisionTimer timer = real_time();
    timer.on_sense_body(at(0), width);
    timer.on_see(at(1));
    timer.decided();
    for (int cycle = 1; cycle <= period; ++cycle) {
      timer.on_sense_body(at(100 * cycle), width);
      EXPECT_EQ(timer.due_at(), at(100 * cycle + (cycle == period ? 30 : 5))) << cycle;
      timer.decided();
    }
  }
}

TEST(DecisionTimer, MultipliesDelaysBySlowDownFactor) {
  DecisionTimer timer = real_time();
  timer.set_slow_down(4);
  timer.on_sense_body(at(0), ViewWidth::kNormal);
  EXPECT_EQ(timer.due_at(), at(120));
}

TEST(DecisionTimer, DecidesOncePerSenseBody) {
  DecisionTimer timer = real_time();
  timer.on_sense_body(at(0), ViewWidth::kNormal);
  timer.decided();
  timer.on_see(at(40));
  EXPECT_FALSE(timer.due(at(99)));
}

TEST(DecisionTimer, CountsUndecidedCyclesAfterFirstDecision) {
  DecisionTimer timer = real_time();
  for (int cycle = 0; cycle < 5; ++cycle) timer.on_sense_body(at(100 * cycle), ViewWidth::kNormal);
  EXPECT_EQ(timer.undecided(), 0);
  timer.decided();
  timer.on_sense_body(at(500), ViewWidth::kNormal);
  EXPECT_EQ(timer.undecided(), 0);
  timer.on_sense_body(at(600), ViewWidth::kNormal);
  timer.on_sense_body(at(700), ViewWidth::kNormal);
  EXPECT_EQ(timer.undecided(), 2);
}

}  // namespace
}  // namespace cls::proxy
