// Random streams: reproducibility, independence, distributions.
#include "soccer/random.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace cls::soccer {
namespace {

TEST(RandomStream, DependsOnSeedPurposeAndKeys) {
  RandomStream a(7, "kick");
  RandomStream b(7, "kick");
  EXPECT_EQ(a.next(), b.next());
  EXPECT_NE(RandomStream(7, "kick").next(), RandomStream(8, "kick").next());
  EXPECT_NE(RandomStream(7, "kick").next(), RandomStream(7, "see").next());
  EXPECT_NE(RandomStream(7, "see", 1).next(), RandomStream(7, "see", 2).next());
  EXPECT_NE(RandomStream(7, "see", 1, 2).next(), RandomStream(7, "see", 2, 1).next());
}

TEST(RandomStream, FirstNumbersNeverChange) {
  // A change of these values changes all matches.
  RandomStream stream(1, "physics");
  EXPECT_EQ(stream.next(), 4544142669314693174ULL);
  EXPECT_EQ(stream.next(), 17296175377362183327ULL);
}

TEST(RandomStream, EmptyRangesConsumeNothing) {
  RandomStream a(7, "kick");
  RandomStream b(7, "kick");
  EXPECT_EQ(a.uniform(2.0, 2.0), 2.0);
  EXPECT_EQ(a.integer(1), 0);
  EXPECT_EQ(a.next(), b.next());
}

TEST(RandomStream, UniformHasExpectedMoments) {
  RandomStream stream(3, "uniform");
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kDraws = 200000;
  for (int i = 0; i < kDraws; ++i) {
    const double x = stream.uniform(3.0, 1.0);
    ASSERT_GE(x, 1.0);
    ASSERT_LT(x, 3.0);
    sum += x;
    squares += (x - 2.0) * (x - 2.0);
  }
  EXPECT_NEAR(sum / kDraws, 2.0, 0.01);
  EXPECT_NEAR(squares / kDraws, 1.0 / 3.0, 0.01);
}

TEST(RandomStream, NormalHasExpectedMoments) {
  RandomStream stream(3, "normal");
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kDraws = 200000;
  for (int i = 0; i < kDraws; ++i) {
    const double x = stream.normal(5.0, 2.0);
    sum += x;
    squares += (x - 5.0) * (x - 5.0);
  }
  EXPECT_NEAR(sum / kDraws, 5.0, 0.03);
  EXPECT_NEAR(squares / kDraws, 4.0, 0.06);
}

TEST(RandomStream, ShufflesAllElementsToAllPositions) {
  RandomStream stream(3, "order");
  std::vector<std::vector<int>> seen(5, std::vector<int>(5, 0));
  for (int i = 0; i < 5000; ++i) {
    std::vector<int> items(5);
    std::iota(items.begin(), items.end(), 0);
    stream.shuffle(std::span<int>(items));
    for (std::size_t k = 0; k < 5; ++k) ++seen[k][static_cast<std::size_t>(items[k])];
  }
  for (const auto& row : seen) {
    for (const int count : row) EXPECT_NEAR(count, 1000, 150);
  }
}

}  // namespace
}  // namespace cls::soccer
