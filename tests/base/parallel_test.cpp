// Work distributed over threads.
#include "base/system/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace cls::base {
namespace {

TEST(ForEachIndex, CallsWorkOncePerIndex) {
  for (const std::size_t jobs : {0, 1, 3, 50}) {
    std::vector<int> done(20, 0);
    std::atomic<std::size_t> sum = 0;
    parallel_for(
        done.size(), jobs, [&done](std::size_t i) { ++done[i]; },
        [&sum](std::size_t so_far) { sum += so_far; });
    EXPECT_EQ(done, std::vector<int>(20, 1));
    EXPECT_EQ(sum, 20u * 21u / 2u);
  }
}

}  // namespace
}  // namespace cls::base
