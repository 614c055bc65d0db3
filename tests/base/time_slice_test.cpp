// Slices of this thread and of another one.
#include "base/system/time_slice.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <thread>

namespace cls::base {
namespace {

using namespace std::chrono_literals;

TEST(TimeSlice, IsOfTheCallingThreadOnly) {
  const auto usual = time_slice_of(0);
  if (usual.count() == 0) GTEST_SKIP() << "this kernel has no slices of threads";
  std::chrono::nanoseconds own{};
  std::thread([&own] {
    set_time_slice(200us);
    own = time_slice_of(::gettid());
  }).join();
  EXPECT_EQ(own, 200us);
  EXPECT_EQ(time_slice_of(0), usual);
}

TEST(TimeSlice, IsNotKnownOfThreadsThatAreGone) {
  pid_t gone = 0;
  std::thread([&gone] { gone = ::gettid(); }).join();
  // The kernel wakes who joins a thread a moment before it forgets the thread.
  while (::tgkill(::getpid(), gone, 0) == 0) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(time_slice_of(gone), 0ns);
}

}  // namespace
}  // namespace cls::base
