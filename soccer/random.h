// Seeded random streams with portable distributions: a seed gives the same match everywhere.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace cls::soccer {

/// One stream of random numbers (xoshiro256++), determined by a seed and a purpose. Streams of
/// different purposes are independent, so a new draw in one place does not shift the others.
/// A plain value: copy it to fork a match. Distributions consume numbers as in
/// docs/spec/simulation-model.md 0 and 11.2.
class RandomStream {
 public:
  /// `purpose` names the stream; `key_a` and `key_b` select one of a family of streams, for example
  /// one per observer and cycle.
  RandomStream(std::uint64_t seed, std::string_view purpose, std::uint64_t key_a = 0,
               std::uint64_t key_b = 0);

  std::uint64_t next();

  /// Uniform in [0, 1), 53 bits.
  double unit();

  /// Uniform in [low, high), or [high, low) if high < low. A range below 1e-10 returns its middle
  /// without consuming a number.
  double uniform(double low, double high);

  /// True with the given probability; always consumes one number.
  bool bernoulli(double probability);

  /// Normal distribution (polar method); consumes two numbers or more.
  double normal(double mean, double deviation);

  /// Uniform in 0..count-1; a count of 1 or less returns 0 without consuming a number.
  int integer(int count);

  template <typename T>
  void shuffle(std::span<T> items) {
    for (std::size_t i = items.size(); i > 1; --i) {
      std::swap(items[i - 1], items[static_cast<std::size_t>(integer(static_cast<int>(i)))]);
    }
  }

 private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace cls::soccer
