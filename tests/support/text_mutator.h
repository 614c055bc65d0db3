// Seeds of the fuzzers and reproducible mutations of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cls::tests {

/// The files of fixtures/fuzz/KIND, sorted by name.
std::vector<std::string> fuzz_seeds(const std::string& kind);

/// Mutates texts with its own random generator.
class TextMutator {
 public:
  explicit TextMutator(std::uint64_t seed = 7) : state_(seed) {}

  /// Changes, cuts, repeats or inserts bytes; at most `max` mutations.
  std::string mutate(std::string bytes, int max = 4);

  /// Mutates one of `texts`.
  std::string mutate_one_of(const std::vector<std::string>& texts, int max = 4) {
    return mutate(texts[next(texts.size())], max);
  }

 private:
  std::size_t next(std::size_t below) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>(state_ >> 33) % below;
  }

  std::uint64_t state_;
};

}  // namespace cls::tests
