// Which of several awaited calls is named.
#include "proxy/playmaker/call_watch.h"

#include <gtest/gtest.h>

#include <thread>

namespace cls::proxy {
namespace {

using proto::Rpc;

TEST(CallWatch, KnowsNoCallWithoutOne) {
  CallWatch watch;
  EXPECT_FALSE(watch.oldest());
  watch.begin(7, Rpc::kGetPlayerActions);
  watch.end(7);
  EXPECT_FALSE(watch.oldest());
}

// Over UDP the coach may be asked before or after the players.
TEST(CallWatch, NamesTheLowestNumberOfACycle) {
  CallWatch watch;
  watch.begin(kCoachNumber, Rpc::kGetCoachActions);
  watch.begin(2, Rpc::kGetPlayerActions);
  watch.begin(1, Rpc::kGetPlayerActions);
  const auto oldest = watch.oldest();
  ASSERT_TRUE(oldest);
  EXPECT_EQ(oldest->agent, 1);
  EXPECT_EQ(oldest->rpc, Rpc::kGetPlayerActions);
  EXPECT_EQ(oldest->others, 2);
}

TEST(CallWatch, NamesTheCallOfAnEarlierCycle) {
  CallWatch watch;
  watch.begin(kCoachNumber, Rpc::kGetCoachActions);
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  watch.begin(1, Rpc::kGetPlayerActions);
  const auto oldest = watch.oldest();
  ASSERT_TRUE(oldest);
  EXPECT_EQ(oldest->agent, kCoachNumber);
  EXPECT_GE(oldest->waited, std::chrono::milliseconds(150));
}

}  // namespace
}  // namespace cls::proxy
