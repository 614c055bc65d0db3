// Results as text, and seeds.
#include "league/matches/fixture.h"

#include <fmt/format.h>

#include <algorithm>

#include "soccer/random.h"

namespace cls::league {
namespace {

// "2:1", or "1:2" when swapped.
std::string ratio(int left, int right, bool swapped) {
  return swapped ? fmt::format("{}:{}", right, left) : fmt::format("{}:{}", left, right);
}

}  // namespace

bool all_have_outcomes(std::span<const ScheduledMatch> matches) {
  return std::ranges::all_of(matches,
                             [](const ScheduledMatch& match) { return match.outcome.has_value(); });
}

std::string result_text(const Outcome& outcome, bool swapped) {
  if (outcome.annulled) return "annulled";
  if (!outcome.counts()) return std::string(name(outcome.end_reason));
  std::string text = ratio(outcome.left_score, outcome.right_score, swapped);
  if (had_shoot_out(outcome)) {
    text +=
        fmt::format(" ({} pen)", ratio(*outcome.left_penalties, *outcome.right_penalties, swapped));
  }
  return text;
}

std::uint64_t pairing_seed(std::uint64_t tournament_seed, int pairing) {
  constexpr std::uint64_t kMask = 0x7fffffff;
  soccer::RandomStream random(tournament_seed, "match seeds");
  const std::uint64_t offset = random.next() % kMask;
  const std::uint64_t key = random.next() & kMask;
  // Every step is a bijection, so distinct pairings have distinct seeds.
  const auto mix = [key](std::uint64_t x) {
    x ^= key;
    x ^= x >> 15;
    x = x * 0x2c1b3c6d & kMask;
    x ^= x >> 12;
    x = x * 0x297a2d39 & kMask;
    return x ^ x >> 15;
  };
  std::uint64_t seed = mix(1 + (static_cast<std::uint64_t>(pairing) + offset) % kMask);
  while (seed == 0) seed = mix(seed);
  return seed;
}

}  // namespace cls::league
