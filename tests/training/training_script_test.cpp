// Whatever a program asks of the C interface, it gets an answer: short run of the fuzzer.
#include <gtest/gtest.h>

#include "tests/fuzz/training_script.h"
#include "tests/support/structure_mutator.h"
#include "tests/support/text_mutator.h"

namespace cls::tests {
namespace {

TEST(TrainingScript, PlaysFuzzerSeeds) {
  const auto scripts = fuzz_seeds("training");
  EXPECT_GE(scripts.size(), 4U);
  for (const std::string& script : scripts) EXPECT_GE(play_training_script(script), 3) << script;
}

TEST(TrainingScript, PlaysMutatedSeeds) {
  constexpr std::size_t kMaxSize = 4096;
  const auto scripts = fuzz_seeds("training");
  TextMutator bytes;
  StructureMutator structure(1);
  for (std::size_t i = 0; i < 300; ++i) {
    play_training_script(bytes.mutate_one_of(scripts));
    play_training_script(structure.mutate(scripts[i % scripts.size()], kMaxSize));
  }
}

}  // namespace
}  // namespace cls::tests
