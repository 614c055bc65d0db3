// xoshiro256++ with own distributions.
#include "soccer/random.h"

#include <bit>
#include <cmath>

#include "base/text/fnv1a.h"
#include "soccer/math.h"

namespace cls::soccer {
namespace {

// SplitMix64: spreads any seed over the whole state, also small and similar ones.
std::uint64_t split_mix(std::uint64_t& state) {
  state += 0x9E3779B97F4A7C15ULL;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31);
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view purpose, std::uint64_t key_a,
                           std::uint64_t key_b) {
  std::uint64_t state = seed;
  for (const std::uint64_t part : {base::fnv1a(purpose), key_a, key_b}) {
    state = split_mix(state) ^ part;
  }
  for (std::uint64_t& word : state_) word = split_mix(state);
}

std::uint64_t RandomStream::next() {
  const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
  const std::uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double RandomStream::unit() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

double RandomStream::uniform(double low, double high) {
  if (low > high) std::swap(low, high);
  if (high - low < math::kEps) return (low + high) / 2.0;
  return low + unit() * (high - low);
}

bool RandomStream::bernoulli(double probability) { return unit() < probability; }

double RandomStream::normal(double mean, double deviation) {
  for (;;) {
    const double x = 2.0 * unit() - 1.0;
    const double y = 2.0 * unit() - 1.0;
    const double q = x * x + y * y;
    if (q <= 0.0 || q > 1.0) continue;
    return mean + deviation * y * std::sqrt(-2.0 * math::log(q) / q);
  }
}

int RandomStream::integer(int count) {
  if (count <= 1) return 0;
  // The high half of a 64 x 32 bit product is uniform up to a bias below 2^-32 per value.
  const std::uint64_t high = next() >> 32;
  return static_cast<int>((high * static_cast<std::uint64_t>(count)) >> 32);
}

}  // namespace cls::soccer
