// Short matches in each protocol version of cls agents, on the embedded server and on rcssserver
// (skipped if not installed): neither reports errors.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/rcssserver.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using json = base::Json;
using Arguments = std::vector<std::string>;

class ProtocolVersion : public testing::TestWithParam<int> {
 protected:
  void play_on(const std::string& server, const std::string& mode) const {
    const TemporaryFolder folder;
    const std::string match_folder = folder.path() / "match";
    EXPECT_THAT(run({cls_binary(), "match", "mock", "mock", "--server", server, "--mode", mode,
                     "--protocol", std::to_string(GetParam()), "--half-time", "3", "--seed", "7",
                     "--set", "server::kick_off_wait=3", "--dir", match_folder}),
                Exits(0, ""));

    const json result = json::parse(read_file(match_folder + "/result.json"));
    EXPECT_EQ(result["end_reason"], "finished");
    EXPECT_EQ(result["cycles"], 60);
    EXPECT_TRUE(result["warnings"].empty()) << result["warnings"];

    for (const char* side : {"left", "right"}) {
      for (const json& player : result[side]["players"]) {
        EXPECT_EQ(player["missed"], 0) << player;
        EXPECT_EQ(player["undecided"], 0) << player;
        EXPECT_GE(player["decisions"], 60) << player;
        EXPECT_GT(player["commands"].value("turn_neck", 0), 0) << player;
      }
    }
  }
};
INSTANTIATE_TEST_SUITE_P(, ProtocolVersion, testing::Values(14, 15, 16, 17, 18, 19),
                         [](const auto& version) { return "V" + std::to_string(version.param); });

TEST_P(ProtocolVersion, PlaysInLockstep) { play_on("embedded", "lockstep"); }

TEST_P(ProtocolVersion, PlaysOnEmbeddedServerOverUdp) { play_on("embedded", "synch"); }

TEST_P(ProtocolVersion, PlaysOnRcssserver) {
  if (rcssserver_program().empty()) GTEST_SKIP() << "no rcssserver on PATH nor in CLS_RCSSSERVER";
  play_on(rcssserver_program(), "synch");
}

}  // namespace
}  // namespace cls::tests
