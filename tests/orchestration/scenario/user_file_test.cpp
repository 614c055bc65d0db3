// Invalid files of users do not crash cls: short run of the fuzzer.
#include <gtest/gtest.h>

#include "tests/fuzz/user_file_checks.h"
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

}  // namespace
}  // namespace cls::tests
