// The Python example as an external Playmaker.
#include <gtest/gtest.h>

#include <iostream>

#include <string>

#include "tests/matches/full_tests.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/python.h"
#include "tests/support/temporary_folder.h"

namespace {

using cls::tests::Command;

TEST(ExternalPlaymaker, PythonExamplePlaysMatch) {
  const std::string python = cls::tests::python_with_grpc();
  if (python.empty()) GTEST_SKIP() << cls::tests::kNoPython;
  const std::string script = cls::tests::source_folder() / "examples/python/playmaker.py";
  Command playmaker({python, script, "--port", "0"},
                    {std::string("PYTHONPATH=") + CLS_BUILD_DIR + "/python"});
  ASSERT_TRUE(playmaker.wait_for_output("listening on ")) << playmaker.finish().err;

  const std::string line = playmaker.out();
  const std::string address = line.substr(13, line.find('\n') - 13);

  cls::tests::TemporaryFolder folder;
  const int half_time = cls::tests::full_tests_requested() ? 300 : 15;
  Command match({cls::tests::cls_binary(), "match", "mock", address, "--seed", "7", "--half-time",
                 std::to_string(half_time), "--set", "server::kick_off_wait=3", "--dir",
                 folder.path()});
  const auto played = match.finish(std::chrono::seconds(600));
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(played.err, "");

  const auto result = cls::base::Json::parse(cls::tests::read_file(folder.path() / "result.json"));
  EXPECT_EQ(result["end_reason"], "finished");
  EXPECT_EQ(result["cycles"], half_time * 20);

  for (const auto& player : result["right"]["players"]) {
    EXPECT_EQ(player["missed"], 0) << player;
    EXPECT_TRUE(player["unimplemented_actions"].empty()) << player;
    EXPECT_GT(player["commands"].value("dash", 0), 20) << player["unum"];
  }
  std::cout << "with " << python << ": " << result["cycles_per_second"] << " cycles/s, mock "
            << result["left"]["score"] << " : " << result["right"]["score"] << " example\n";
}

}  // namespace
