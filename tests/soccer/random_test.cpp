// Random streams: reproducibility, independence, distributions.
#include "soccer/random.h"

#include <gtest/gtest.h>

#include <numeric>
#include <utility>
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

/// The mean of many draws, and their mean square distance from `center`.
template <typename Draw>
std::pair<double, double> moments(double center, Draw draw) {
  constexpr int kDraws = 200000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = draw();
    sum += x;
    squares += (x - center) * (x - center);
  }
  return {sum / kDraws, squares / kDraws};
}

TEST(RandomStream, UniformHasExpectedMoments) {
  RandomStream stream(3, "uniform");
  const auto draw = [&stream] {
    const double x = stream.uniform(3.0, 1.0);
    EXPECT_GE(x, 1.0);
    EXPECT_LT(x, 3.0);
    return x;
  };

  const auto [mean, variance] = moments(2.0, draw);
  EXPECT_NEAR(mean, 2.0, 0.01);
  EXPECT_NEAR(variance, 1.0 / 3.0, 0.01);
}

TEST(RandomStream, NormalHasExpectedMoments) {
  RandomStream stream(3, "normal");
  const auto [mean, variance] = moments(5.0, [&stream] { return stream.normal(5.0, 2.0); });
  EXPECT_NEAR(mean, 5.0, 0.03);
  EXPECT_NEAR(variance, 4.0, 0.06);
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
