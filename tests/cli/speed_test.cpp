// The verdict on speed: in the result, in the summary, and early in a slow match.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;

struct Played {
  CommandResult command;
  json speed;
};

Played play_with_delay(int delay_ms, const std::vector<std::string>& more) {
  const TemporaryFolder folder;
  const auto script = folder.path() / "slow.json";
  std::ofstream(script) << R"({"otherwise": "simple", "faults": {"delay_ms": )" << delay_ms << "}}";
  const std::vector<std::string> arguments = joined(
      {cls_binary(), "match", "mock", "mock:" + script.string(), "--dir", folder.path() / "match"},
      more);
  Played played;
  played.command = run(arguments);
  const json result = json::parse(read_file(folder.path() / "match" / "result.json"));
  played.speed = result["speed"];
  return played;
}

void expect_whole(const json& shares) {
  double sum = 0.0;
  for (const auto& [name, share] : shares.items()) sum += share.get<double>();
  EXPECT_NEAR(sum, 1.0, 1e-9) << shares;
}

class Speed : public testing::TestWithParam<const char*> {};

TEST_P(Speed, NamesTheSlowPlaymaker) {
  const Played played = play_with_delay(
      600, {"--cycles", "6", "--mode", GetParam(), "--set", "server::kick_off_wait=3"});
  ASSERT_TRUE(played.speed.is_object()) << played.command.err;
  EXPECT_EQ(played.speed["limited_by"], "right playmaker") << played.speed;
  EXPECT_GT(played.speed["shares"]["right_playmaker"], 0.4) << played.speed;
  EXPECT_GE(played.speed["decision_ms"]["p99"], 600.0);
  EXPECT_FALSE(played.speed["fits_100_ms"].get<bool>());
  expect_whole(played.speed["shares"]);
  EXPECT_THAT(played.command.out, HasSubstr("\n  limited by the right Playmaker ("));
  EXPECT_THAT(played.command.out, HasSubstr("ms: too slow for real time\n"));
}

INSTANTIATE_TEST_SUITE_P(Modes, Speed, testing::Values("lockstep", "synch"));

TEST(SpeedEstimate, SaysHowLongASlowMatchTakes) {
  const Played played = play_with_delay(
      600, {"--time-limit", "20", "--set", "server::kick_off_wait=3", "--cycles", "6000"});
  EXPECT_THAT(played.command.err, HasSubstr(" cycles/s: 6000 cycles will take about "));
  EXPECT_THAT(played.command.err, HasSubstr("min; limited by the right Playmaker ("));
}

}  // namespace
}  // namespace cls::tests
