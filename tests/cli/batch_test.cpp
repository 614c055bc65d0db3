// Matches with one call per team and cycle are the matches with a call per agent.
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mock-server/mock.h"
#include "mock-server/service/raw_service.h"
#include "mock-server/service/team_responder.h"
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
  static void expect_same_logs(const Played& single, const Played& batch, const std::string& what) {
    EXPECT_GT(single.rcg.size(), 100000u);
    EXPECT_TRUE(single.rcg == batch.rcg) << what << ": rcg differs";
    EXPECT_TRUE(single.rcl == batch.rcl) << what << ": rcl differs";
  }

  void expect_same_match(const std::string& left, const std::string& right, const std::string& seed,
                         const Arguments& more = {}) {
    const Played single = play("never", left, right, seed, more);
    const Played batch = play("always", left, right, seed, more);
    expect_same_logs(single, batch, left + ", seed " + seed);
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

TEST_F(Batch, OversizedReplyOfOneAgentIsMissedByThatAgentOnly) {
  const std::string script = folder_.path() / "oversize.json";
  std::ofstream(script) << R"({"otherwise": "simple",
             "faults": {"oversize": 1, "only": {"cycle": [4, 4], "unum": [5]}}})";
  cycles_ = "8";
  const Played single = play("never", "mock:" + script, "mock", "1");
  const Played batch = play("always", "mock:" + script, "mock", "1");
  EXPECT_TRUE(single.rcg == batch.rcg);
  for (const Played* played : {&single, &batch}) {
    for (const json& player : played->result["left"]["players"]) {
      EXPECT_EQ(player["missed"], player["unum"] == 5 ? 1 : 0) << player["unum"];
    }
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

TEST_F(Batch, SameMatchOverUnixSocket) {
  const std::string path = folder_.path() / "socket";
  const auto mock = cls::mock_server::make_mock("");
  ASSERT_TRUE(mock);
  cls::mock_server::RequestHandler handler(*mock->behavior, nullptr);
  cls::mock_server::Responder responder(handler, {}, {});
  using cls::mock_server::RawService;
  RawService game(0, cls::proto::kAgentRpcs, cls::mock_server::kStateMemory,
                  [&](auto rpc, const auto& request, auto& reply, auto&) {
                    return responder.respond(rpc, request, reply);
                  });
  RawService team(cls::proto::kAgentRpcs, cls::proto::kRpcs, cls::mock_server::kTeamMemory,
                  [&](auto rpc, const auto& request, auto& reply, auto& workspace) {
                    return respond_to_team(responder, rpc, request, reply, workspace);
                  });
  grpc::ServerBuilder builder;
  builder.RegisterService(&game);
  builder.RegisterService(&team);
  builder.AddListeningPort("unix:" + path, grpc::InsecureServerCredentials());
  const auto server = builder.BuildAndStart();
  ASSERT_NE(server, nullptr);
  for (int seed = 1; seed <= seeds(); ++seed) {
    expect_same_match("unix:" + path, "mock", std::to_string(seed));
  }
}

TEST_F(Batch, SameMatchWithWholeStates) {
  const std::string script = folder_.path() / "whole.json";
  std::ofstream(script) << R"({"otherwise": "simple", "faults": {"full_states": true}})";
  for (int seed = 1; seed <= seeds(); ++seed) {
    expect_same_match("mock:" + script, "mock", std::to_string(seed));
  }
}

// The example as it is, or as a subclass: Python lines that follow `import playmaker`.
std::string python_example(const std::string& python, const std::string& main) {
  const std::string folder = (cls::tests::source_folder() / "examples/python").string();
  return "run:PYTHONPATH=" CLS_BUILD_DIR "/python:" + folder + " " + python + " " + main +
         " --port {port}";
}

TEST_F(Batch, SameMatchOfPythonExampleInBothEncodings) {
  const std::string python = cls::tests::python_with_grpc();
  if (python.empty()) GTEST_SKIP() << cls::tests::kNoPython;
  cycles_ = "60";
  const Arguments name = {"--left-name", "example"};  // not the name of the file
  std::vector<Played> played;
  for (const char* lean : {"True", "False"}) {
    const std::string main = folder_.path() / ("lean" + std::string(lean) + ".py");
    std::ofstream(main) << "import playmaker\nplaymaker.Team.lean_states = " << lean
                        << "\nplaymaker.main()\n";
    played.push_back(play("always", python_example(python, main), "mock", "1", name));
  }
  const std::string as_it_is = python_example(
      python, (cls::tests::source_folder() / "examples/python/playmaker.py").string());
  played.push_back(play("never", as_it_is, "mock", "1", name));
  expect_same_logs(played[2], played[0], "lean States");
  expect_same_logs(played[2], played[1], "whole States");
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
