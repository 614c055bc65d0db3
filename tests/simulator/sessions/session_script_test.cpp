// Short form of the session fuzzer: invalid conversations do no harm.
#include <gtest/gtest.h>

#include <string>

#include "tests/fuzz/session_script.h"
#include "tests/support/text_mutator.h"

namespace cls::tests {
namespace {

TEST(SessionScript, PlaysSeedsOfFuzzer) {
  const auto scripts = fuzz_seeds("session");
  EXPECT_GE(scripts.size(), 4u);
  for (const std::string& script : scripts) play_session_script(script);
}

TEST(SessionScript, PlaysMutatedScripts) {
  const auto scripts = fuzz_seeds("session");
  TextMutator mutator;
  for (int i = 0; i < 300; ++i) play_session_script(mutator.mutate_one_of(scripts, 8));
}

}  // namespace
}  // namespace cls::tests
