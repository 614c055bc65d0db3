// Fuzzer seeds, intact and with a thousand mutations, checked like in the fuzzers.
#include <gtest/gtest.h>

#include <string>

#include "tests/fuzz/log_checks.h"
#include "tests/fuzz/table_checks.h"
#include "tests/support/text_mutator.h"

namespace cls::tests {
namespace {

void check_seeds(const char* kind, void (*check)(std::string_view), int variants) {
  TextMutator mutator;
  const auto seeds = fuzz_seeds(kind);
  EXPECT_GE(seeds.size(), 3u);
  for (const std::string& seed : seeds) {
    check(seed);
    for (int i = 0; i < variants; ++i) check(mutator.mutate(seed));
  }
}

TEST(FuzzCorpus, GameLogReaderHoldsInvariantsOnCorruptInput) {
  check_seeds("rcg", check_game_log, 80);
}

TEST(FuzzCorpus, TextLogReaderHoldsInvariantsOnCorruptInput) {
  check_seeds("rcl", check_text_log, 300);
}

TEST(FuzzCorpus, TableReadersHoldInvariantsOnCorruptInput) {
  check_seeds("table", check_table, 100);
}

}  // namespace
}  // namespace cls::tests
