// Sharing out processors between two sides.
#include "base/system/host.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cls::base {
namespace {

using Cores = std::vector<std::vector<int>>;
using Halves = std::array<std::vector<int>, 2>;

TEST(Halves, GiveEachSideAsMuchAsTheOther) {
  EXPECT_EQ(halves_of(Cores{{0}, {1}}), (Halves{{{0}, {1}}}));
  EXPECT_EQ(halves_of(Cores{{0}, {1}, {2}}), (Halves{{{0}, {2}}}));
  EXPECT_EQ(halves_of(Cores{{2}, {3}, {6}, {7}}), (Halves{{{2, 3}, {6, 7}}}));
}

TEST(Halves, DoNotShareAPhysicalCore) {
  // Four cores of two threads, numbered as most machines do.
  EXPECT_EQ(halves_of(Cores{{0, 4}, {1, 5}, {2, 6}, {3, 7}}),
            (Halves{{{0, 4, 1, 5}, {2, 6, 3, 7}}}));
  EXPECT_EQ(halves_of(Cores{{0, 3}, {1, 4}, {2, 5}}), (Halves{{{0, 3}, {2, 5}}}));
}

TEST(Halves, AreThreadsWhereThereIsOnlyOneCore) {
  EXPECT_EQ(halves_of(Cores{{0, 1}}), (Halves{{{0}, {1}}}));
  EXPECT_EQ(halves_of(Cores{{0, 1, 2}}), (Halves{{{0}, {2}}}));
}

TEST(Halves, AreEmptyForOneProcessor) {
  EXPECT_EQ(halves_of(Cores{{5}}), Halves());
  EXPECT_EQ(halves_of(Cores{}), Halves());
}

TEST(Host, CoresHoldAllProcessorsOnce) {
  std::vector<int> all;
  for (const auto& core : allowed_cores()) all.insert(all.end(), core.begin(), core.end());
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, allowed_processors());
  EXPECT_EQ(usable_cores(), static_cast<int>(allowed_cores().size()));
}

}  // namespace
}  // namespace cls::base
