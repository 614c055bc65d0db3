// Servers and Playmakers that make no sense harm no agent: the short form of the fuzzer.
#include <gtest/gtest.h>

#include "tests/fuzz/agent_script.h"
#include "tests/support/damage.h"

namespace cls::tests {
namespace {

TEST(AgentScript, TheSeedsOfTheFuzzerPlay) {
  const auto scripts = fuzz_seeds("agent");
  EXPECT_GE(scripts.size(), 4U);
  for (const std::string& script : scripts)
    EXPECT_GT(play_agent_script(script), 3) << script.substr(0, 60);
}

TEST(AgentScript, DamagedOnesPlayToo) {
  const auto scripts = fuzz_seeds("agent");
  Damager damager;
  for (int i = 0; i < 200; ++i) play_agent_script(damager.damage_one_of(scripts, 8));
}

}  // namespace
}  // namespace cls::tests
