// Invalid messages of servers and Playmakers do not crash an agent: short run of the fuzzer.
#include <gtest/gtest.h>

#include "tests/fuzz/agent_script.h"
#include "tests/support/text_mutator.h"

namespace cls::tests {
namespace {

TEST(AgentScript, RunsFuzzerSeeds) {
  const auto scripts = fuzz_seeds("agent");
  EXPECT_GE(scripts.size(), 4U);
  for (const std::string& script : scripts)
    EXPECT_GT(play_agent_script(script), 3) << script.substr(0, 60);
}

TEST(AgentScript, RunsMutatedSeeds) {
  const auto scripts = fuzz_seeds("agent");
  TextMutator mutator;
  for (int i = 0; i < 200; ++i) play_agent_script(mutator.mutate_one_of(scripts, 8));
}

}  // namespace
}  // namespace cls::tests
