// Invalid files of users do not crash cls: short run of the fuzzer.
#include <gtest/gtest.h>

#include "tests/fuzz/user_file_checks.h"
#include "tests/support/structure_mutator.h"
#include "tests/support/text_mutator.h"

namespace cls::tests {
namespace {

TEST(UserFiles, RunFuzzerSeeds) {
  const auto files = fuzz_seeds("user_file");
  EXPECT_GE(files.size(), 7U);
  for (const std::string& file : files) check_user_file(file);
}

TEST(UserFiles, RunMutatedSeeds) {
  const auto files = fuzz_seeds("user_file");
  TextMutator mutator;
  for (int i = 0; i < 1000; ++i) check_user_file(mutator.mutate_one_of(files, 8));
}

TEST(UserFiles, RunSeedsOfAnotherStructure) {
  constexpr std::size_t kMaxSize = 16384;
  const auto files = fuzz_seeds("user_file");
  StructureMutator mutator(1);
  for (std::size_t i = 0; i < 1000; ++i) {
    const std::string& seed = files[i % files.size()];
    check_user_file(seed.substr(0, 1) + mutator.mutate(seed.substr(1), kMaxSize));
  }
}

}  // namespace
}  // namespace cls::tests
