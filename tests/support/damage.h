// The seeds of the fuzzers, and damage to them that is the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cls::tests {

/// The files of fixtures/fuzz/KIND in order of their names.
std::vector<std::string> fuzz_seeds(const std::string& kind);

/// Breaks texts in many ways, by a generator of its own.
class Damager {
 public:
  /// Bytes changed, cut, repeated, put in; up to `most` changes.
  std::string damage(std::string bytes, int most = 4);

  /// The same done to one of `texts`.
  std::string damage_one_of(const std::vector<std::string>& texts, int most = 4) {
    return damage(texts[next(texts.size())], most);
  }

 private:
  std::size_t next(std::size_t below) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>(state_ >> 33) % below;
  }

  std::uint64_t state_ = 7;
};

}  // namespace cls::tests
