// Pairs of numbers against the same operations one by one.
#include "training/features/pair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "soccer/random.h"

namespace cls::training {
namespace {

std::array<double, 2> numbers(const Pair& pair) { return {pair.first(), pair.second()}; }

TEST(Pair, HasTheBitsOfTwoNumbers) {
  soccer::RandomStream random(1, "pairs");
  for (int i = 0; i < 1000; ++i) {
    const double a = random.uniform(-100.0, 100.0);
    const double b = random.uniform(-100.0, 100.0);
    const double c = random.uniform(-100.0, 100.0);
    const double d = random.uniform(-100.0, 100.0);
    const Pair x(a, b);
    const Pair y(soccer::Vec2{c, d});

    using Both = std::array<double, 2>;
    EXPECT_EQ(numbers(x + y), (Both{a + c, b + d}));
    EXPECT_EQ(numbers(x - y), (Both{a - c, b - d}));
    EXPECT_EQ(numbers(x * y), (Both{a * c, b * d}));
    EXPECT_EQ(numbers(x / y), (Both{a / c, b / d}));
    EXPECT_EQ(numbers(x.swapped()), (Both{b, a}));
    EXPECT_EQ(numbers(Pair::of(a)), (Both{a, a}));
    EXPECT_EQ(numbers(x.clamped(-40.0, 30.0)),
              (Both{std::clamp(a, -40.0, 30.0), std::clamp(b, -40.0, 30.0)}));

    std::array<float, 3> out{};
    x.store(&out[1]);
    EXPECT_EQ(out, (std::array<float, 3>{0.0F, static_cast<float>(a), static_cast<float>(b)}));
  }
}

}  // namespace
}  // namespace cls::training
