// Splitting processors between two sides.
#include "base/system/host.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cls::base {
namespace {

using Cores = std::vector<std::vector<int>>;
using Halves = std::array<std::vector<int>, 2>;

TEST(SplitInHalf, MakesHalvesOfEqualSize) {
  EXPECT_EQ(split_in_half(Cores{{0}, {1}}), (Halves{{{0}, {1}}}));
  EXPECT_EQ(split_in_half(Cores{{0}, {1}, {2}}), (Halves{{{0}, {2}}}));
  EXPECT_EQ(split_in_half(Cores{{2}, {3}, {6}, {7}}), (Halves{{{2, 3}, {6, 7}}}));
}

TEST(SplitInHalf, SharesNoPhysicalCore) {
  // Four cores with two threads each, numbered as Linux usually does.
  EXPECT_EQ(split_in_half(Cores{{0, 4}, {1, 5}, {2, 6}, {3, 7}}),
            (Halves{{{0, 4, 1, 5}, {2, 6, 3, 7}}}));
  EXPECT_EQ(split_in_half(Cores{{0, 3}, {1, 4}, {2, 5}}), (Halves{{{0, 3}, {2, 5}}}));
}

TEST(SplitInHalf, SplitsThreadsOfSingleCore) {
  EXPECT_EQ(split_in_half(Cores{{0, 1}}), (Halves{{{0}, {1}}}));
  EXPECT_EQ(split_in_half(Cores{{0, 1, 2}}), (Halves{{{0}, {2}}}));
}

TEST(SplitInHalf, IsEmptyForOneProcessor) {
  EXPECT_EQ(split_in_half(Cores{{5}}), Halves());
  EXPECT_EQ(split_in_half(Cores{}), Halves());
}

TEST(Host, CoresContainEachProcessorOnce) {
  std::vector<int> all;
  for (const auto& core : allowed_cores()) all.insert(all.end(), core.begin(), core.end());
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, allowed_processors());
  EXPECT_EQ(usable_cores(), static_cast<int>(allowed_cores().size()));
}

}  // namespace
}  // namespace cls::base
