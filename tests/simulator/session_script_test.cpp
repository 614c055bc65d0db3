// Conversations that make no sense harm nobody: the short form of the fuzzer.
#include <gtest/gtest.h>

#include <string>

#include "tests/fuzz/session_script.h"
#include "tests/support/damage.h"

namespace cls::tests {
namespace {

TEST(SessionScript, TheSeedsOfTheFuzzerPlay) {
  const auto scripts = fuzz_seeds("session");
  EXPECT_GE(scripts.size(), 4u);
  for (const std::string& script : scripts) play_session_script(script);
}

TEST(SessionScript, DamagedOnesPlayToo) {
  const auto scripts = fuzz_seeds("session");
  Damager damager;
  for (int i = 0; i < 300; ++i) play_session_script(damager.damage_one_of(scripts, 8));
}

}  // namespace
}  // namespace cls::tests
