// The seeds of the fuzzers, whole and broken in a thousand ways, through the fuzzers' checks.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/fuzz/log_checks.h"
#include "tests/support/damage.h"

namespace cls::tests {
namespace {

void check_seeds(const char* kind, void (*check)(std::string_view), int variants) {
  Damager damager;
  const auto seeds = fuzz_seeds(kind);
  EXPECT_GE(seeds.size(), 3u);
  for (const std::string& seed : seeds) {
    check(seed);
    for (int i = 0; i < variants; ++i) check(damager.damage(seed));
  }
}

TEST(FuzzCorpus, GameLogsKeepTheirPromisesHoweverDamaged) {
  check_seeds("rcg", check_game_log, 80);
}

TEST(FuzzCorpus, TextLogsKeepTheirPromisesHoweverDamaged) {
  check_seeds("rcl", check_text_log, 300);
}

}  // namespace
}  // namespace cls::tests
