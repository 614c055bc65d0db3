// Invalid messages of servers and Playmakers do not crash an agent: short run of the fuzzer.
#include <gtest/gtest.h>

#include "tests/fuzz/agent_script.h"
#include "tests/support/text_mutator.h"

namespace cls::tests {
namespace {

TEST(AgentScript, RunsFuzzerSeeds) {
  const auto scripts = fuzz_seeds("agent");
  int deciding = 0;  // the others are findings, which need not decide
  for (const std::string& script : scripts) deciding += play_agent_script(script) > 3;
  EXPECT_GE(deciding, 4);
}

TEST(AgentScript, RunsMutatedSeeds) {
  const auto scripts = fuzz_seeds("agent");
  TextMutator mutator;
  for (int i = 0; i < 200; ++i) play_agent_script(mutator.mutate_one_of(scripts, 8));
}

}  // namespace
}  // namespace cls::tests
