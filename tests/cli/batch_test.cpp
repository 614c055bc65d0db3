// Matches with one call per team and cycle are the matches with a call per agent.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/python.h"
#include "tests/support/temporary_folder.h"

namespace {

using cls::tests::cls_binary;
using cls::tests::Command;
using cls::tests::CommandResult;
using nlohmann::json;
using Arguments = std::vector<std::string>;

class Batch : public testing::Test {
 protected:
  struct Played {
    std::string rcg;
    std::string rcl;
    json result;
  };

  Played play(const std::string& batch, const std::string& left, const std::string& right,
              const std::string& seed, const Arguments& more = {}) {
    const auto folder = folder_.path() / ("match" + std::to_string(++matches_));
    Arguments arguments = {cls_binary(), "match",  left,   right,      "--batch",
                           batch,        "--seed", seed,   "--cycles", cycles_,
                           "--json",     "--dir",  folder, "--coach"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandResult played = cls::tests::run(arguments);
    EXPECT_EQ(played.exit_code, 0) << played.err;
    return {cls::tests::read_file(folder / "match.rcg"),
            cls::tests::read_file(folder / "match.rcl"), json::parse(played.out, nullptr, false)};
  }

  // Not EXPECT_EQ: it would print megabytes.
  void expect_same_match(const std::string& left, const std::string& right, const std::string& seed,
                         const Arguments& more = {}) {
    const Played single = play("never", left, right, seed, more);
    const Played batch = play("always", left, right, seed, more);
    EXPECT_GT(single.rcg.size(), 100000u);
    EXPECT_TRUE(single.rcg == batch.rcg) << left << ", seed " << seed << ": rcg differs";
    EXPECT_TRUE(single.rcl == batch.rcl) << left << ", seed " << seed << ": rcl differs";
    for (const char* side : {"left", "right"}) {
      const json& a = single.result[side]["players"];
      const json& b = batch.result[side]["players"];
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i]["missed_by"], b[i]["missed_by"]) << side << ' ' << a[i]["unum"];
        EXPECT_EQ(a[i]["decisions"], b[i]["decisions"]) << side << ' ' << a[i]["unum"];
      }
    }
  }

  static int seeds() { return std::getenv("CLS_FULL") != nullptr ? 20 : 2; }

  cls::tests::TemporaryFolder folder_;
  int matches_ = 0;
  std::string cycles_ = "120";
};

TEST_F(Batch, SameMatchInProcess) {
  for (int seed = 1; seed <= seeds(); ++seed) {
    expect_same_match("mock", "mock", std::to_string(seed));
  }
}

TEST_F(Batch, SameMatchWithPlannerChoices) {
  for (int seed = 1; seed <= seeds(); ++seed) {
    expect_same_match("mock:planner", "mock:planner", std::to_string(seed));
  }
}

TEST_F(Batch, SameMatchWithFaultsOfSingleAgents) {
  const std::string script = folder_.path() / "faults.json";
  std::ofstream(script) << R"({"otherwise": "simple",
                               "faults": {"error": 0.05, "garbage": 0.05}})";
  for (int seed = 1; seed <= seeds(); ++seed) {
    expect_same_match("mock:" + script, "mock", std::to_string(seed), {"--max-missed", "1000"});
  }
}

TEST_F(Batch, SameMatchOverTcp) {
  Command mock({cls_binary(), "mock", "--port", "0"});
  ASSERT_TRUE(mock.wait_for_output("127.0.0.1:"));
  const std::string out = mock.out();
  const std::string endpoint =
      out.substr(out.find("127.0.0.1:"),
                 out.find_first_of(" \n", out.find("127.0.0.1:")) - out.find("127.0.0.1:"));
  for (int seed = 1; seed <= seeds(); ++seed) {
    expect_same_match(endpoint, "mock", std::to_string(seed));
  }
}

TEST_F(Batch, SameMatchOfPythonExample) {
  const std::string python = cls::tests::python_with_grpc();
  if (python.empty()) GTEST_SKIP() << cls::tests::kNoPython;
  const std::string example =
      "run:PYTHONPATH=" CLS_BUILD_DIR "/python " + python + " " +
      (cls::tests::source_folder() / "examples/python/playmaker.py").string() + " --port {port}";
  cycles_ = "60";
  expect_same_match(example, "mock", "1");
}

TEST_F(Batch, RecordingHoldsCallsOfAgents) {
  const std::string single = folder_.path() / "single.rpc";
  const std::string batch = folder_.path() / "batch.rpc";
  play("never", "mock", "mock:hold", "3", {"--record-rpc", single});
  play("always", "mock", "mock:hold", "3", {"--record-rpc", batch});
  for (const std::string& file : {single, batch}) {
    const CommandResult replayed =
        cls::tests::run({cls_binary(), "test", "--replay", file, "mock", "--json"});
    EXPECT_EQ(replayed.exit_code, 0) << file << replayed.err;
  }
}

TEST_F(Batch, OlderPlaymakerIsAskedForEachAgentWithoutWarning) {
  const std::string script = folder_.path() / "older.json";
  std::ofstream(script)
      << R"({"otherwise": "simple", "faults": {"unimplemented": ["GetBestPlannerAction"]}})";
  const Played played = play("auto", "mock:" + script, "mock", "1");
  EXPECT_EQ(played.result["warnings"], json::array());
  EXPECT_GT(played.result["left"]["players"][0]["decisions"], 100);
}

TEST_F(Batch, RequiredServiceThatIsMissingRefusesMatch) {
  const std::string script = folder_.path() / "older.json";
  std::ofstream(script)
      << R"({"otherwise": "simple", "faults": {"unimplemented": ["GetBestPlannerAction"]}})";
  const CommandResult refused =
      cls::tests::run({cls_binary(), "match", "mock:" + script, "mock", "--batch", "always",
                       "--cycles", "10", "--dir", folder_.path() / "refused"});
  EXPECT_EQ(refused.exit_code, 69);
  EXPECT_NE(refused.err.find("does not implement TeamPlaymaker"), std::string::npos) << refused.err;
}

}  // namespace
