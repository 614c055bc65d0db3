// Matches with one call per team and cycle are the matches with a call per agent.
#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "mock-server/mock.h"
#include "mock-server/service/raw_service.h"
#include "mock-server/service/team_responder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/python.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;
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
    const CommandResult played =
        run(joined({cls_binary(), "match", left, right, "--batch", batch, "--seed", seed,
                    "--cycles", cycles_, "--json", "--dir", folder, "--coach"},
                   more));
    EXPECT_EQ(played.exit_code, 0) << played.err;
    return {read_file(folder / "match.rcg"), read_file(folder / "match.rcl"),
            json::parse_or_discarded(played.out)};
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

  // Against the bundled team, with every seed.
  void expect_same_matches(const std::string& playmaker, const Arguments& more = {}) {
    for (int seed = 1; seed <= seeds(); ++seed) {
      expect_same_match(playmaker, "mock", std::to_string(seed), more);
    }
  }

  std::string file(const std::string& name, const std::string& text) {
    const std::string path = folder_.path() / name;
    std::ofstream(path) << text;
    return path;
  }

  // A mock that decides by what it reads in States, lists and dictionaries among it.
  std::string scripted() {
    return file("scripted.json", R"({
      "rules": [
        {"when": {"unum": 1}, "reply": "planner"},
        {"when": {"state": {"teammates.size": {"<": 8}}}, "reply": [{"body_turn_to_ball": {}}]},
        {"when": {"state": {"their_players_dict.9.pos_count": {">": 2}}},
         "reply": [{"dash": {"power": 60}}, {"neck_scan_field": {}}]},
        {"when": {"unum": [9, 10, 11], "state": {"self.is_kickable": true}},
         "reply": [{"helios_offensive_planner": {"direct_pass": true, "simple_shoot": true,
                                                 "server_side_decision": true}}]}
      ],
      "otherwise": "simple"})");
  }

  // A mock of the interface before GetBestPlannerAction.
  std::string older() {
    return file("older.json", R"({"otherwise": "simple",
      "faults": {"unimplemented": ["GetBestPlannerAction"]}})");
  }

  static bool long_form() { return std::getenv("CLS_FULL") != nullptr; }
  static int seeds() { return long_form() ? 20 : 2; }

  TemporaryFolder folder_;
  int matches_ = 0;
  std::string cycles_ = long_form() ? "300" : "120";
};

TEST_F(Batch, SameMatchInProcess) { expect_same_matches("mock"); }

TEST_F(Batch, SameMatchOfScriptInProcess) { expect_same_matches("mock:" + scripted()); }

TEST_F(Batch, SameMatchWithPlannerChoices) {
  for (int seed = 1; seed <= seeds(); ++seed) {
    expect_same_match("mock:planner", "mock:planner", std::to_string(seed));
  }
}

TEST_F(Batch, SameMatchWithFaultsOfSingleAgents) {
  const std::string script = file("faults.json", R"({"otherwise": "simple",
      "faults": {"error": 0.05, "garbage": 0.05}})");
  expect_same_matches("mock:" + script, {"--max-missed", "1000"});
}

// A fault of the mock has the same effect on an agent that is asked alone and on one of a team.
TEST_F(Batch, SameMatchWithEachFault) {
  cycles_ = "40";
  const Arguments limits = {"--max-missed", "1000", "--rpc-deadline", "1000"};

  for (const std::string fault : {
           R"("error": 0.1, "status": "INTERNAL", "message": "x", "seed": 3)",
           R"("garbage": 0.1, "only": {"unum": [2, 5, 8]})",
           R"("oversize": 0.1, "only": {"unum": [3, 7]})",  // more would exceed the team's limit
           R"("drop": 1, "only": {"cycle": [10, 11], "unum": [4, 9]})",
           R"("delay_ms": 2, "jitter_ms": 3)",
           R"("slow_start_ms": 300)",
           R"("wrong_client_id": true)",
           R"("restart_at_cycle": 15, "restart_cycles": 5)",
           R"("full_states": true)",
       }) {
    const std::string script =
        file("fault.json", R"({"otherwise": "simple", "faults": {)" + fault + "}}");
    SCOPED_TRACE(fault);
    expect_same_match("mock:" + script, "mock", "1", limits);
  }
}

TEST_F(Batch, OversizedReplyOfOneAgentIsMissedByThatAgentOnly) {
  const std::string script = file("oversize.json", R"({"otherwise": "simple",
      "faults": {"oversize": 1, "only": {"cycle": [4, 4], "unum": [5]}}})");
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

// The address in what a program prints when it listens.
std::string printed_address(const Command& program) {
  const std::string out = program.out();
  const std::size_t begin = out.find("127.0.0.1:");
  return out.substr(begin, out.find_first_of(" \n", begin) - begin);
}

// A program in its first seconds on a busy host needs more than a fixed short time.
TEST_F(Batch, GivesRegisterTeamHalfOfTheStartTime) {
  const std::string script =
      file("silent.json", R"({"otherwise": "simple", "faults": {"slow_start_ms": 600000}})");
  Command program({cls_binary(), "mock", script, "--port", "0"});
  ASSERT_TRUE(program.wait_for_output("127.0.0.1:"));
  EXPECT_THAT(run({cls_binary(), "match", printed_address(program), "mock", "--start-timeout", "8",
                   "--cycles", "5", "--dir", folder_.path() / "refused"}),
              Exits(69, HasSubstr("no reply to RegisterTeam within 4000 ms")));
}

TEST_F(Batch, SameMatchOverTcp) {
  for (const std::string& spec : {std::string("simple"), scripted()}) {
    Command mock({cls_binary(), "mock", spec, "--port", "0"});
    ASSERT_TRUE(mock.wait_for_output("127.0.0.1:"));
    expect_same_matches(printed_address(mock));
  }
}

TEST_F(Batch, SameMatchOverUnixSocket) {
  for (const std::string& spec : {std::string("simple"), scripted()}) {
    const std::string path = folder_.path() / "socket";
    const auto mock = cls::mock_server::make_mock(spec);
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
    expect_same_matches("unix:" + path);
  }
}

TEST_F(Batch, SameMatchWithWholeStates) {
  expect_same_matches("mock:" + file("whole.json", R"({"otherwise": "simple",
      "faults": {"full_states": true}})"));
}

// What a Python program of the example needs in front of it.
std::string python_path() {
  return std::string(CLS_BUILD_DIR) + "/python:" + (source_folder() / "examples/python").string();
}

class PythonBatch : public Batch {
 protected:
  PythonBatch() : python_(python_with_grpc()) { cycles_ = long_form() ? "120" : "60"; }
  void SetUp() override {
    if (python_.empty()) GTEST_SKIP() << kNoPython;
  }

  static int seeds() { return long_form() ? 20 : 1; }
  std::string started(const std::string& program) const {
    return "run:PYTHONPATH=" + python_path() + " " + python_ + " " + program + " --port {port}";
  }

  std::string python_;
  Arguments name_ = {"--left-name", "example"};  // not the name of the file
};

// Over TCP, and the example as it is, or as a subclass.
TEST_F(PythonBatch, SameMatchInBothEncodings) {
  const auto example = [this](const std::string& lean) {
    return started(file("lean" + lean + ".py", "import playmaker\nplaymaker.Team.lean_states = " +
                                                   lean + "\nplaymaker.main()\n"));
  };
  const std::string as_it_is = started((source_folder() / "examples/python/playmaker.py").string());
  for (int i = 1; i <= seeds(); ++i) {
    const std::string seed = std::to_string(i);
    const Played single = play("never", as_it_is, "mock", seed, name_);
    expect_same_logs(single, play("always", example("True"), "mock", seed, name_),
                     "lean States, seed " + seed);
    expect_same_logs(single, play("always", example("False"), "mock", seed, name_),
                     "whole States, seed " + seed);
  }
}

TEST_F(PythonBatch, SameMatchOverUnixSocket) {
  const std::string path = folder_.path() / "socket";
  const std::string program = file("unix.py", R"(import sys
from concurrent import futures
import grpc
import playmaker
from cls_playmaker import errors, proto, team, team_playmaker_pb2_grpc
example = playmaker.Team(False)

server = grpc.server(futures.ThreadPoolExecutor(max_workers=16))

proto.add_GameServicer_to_server(example, server)
team_playmaker_pb2_grpc.add_TeamPlaymakerServicer_to_server(
    team.TeamServicer(example, errors.Errors()), server)
server.add_insecure_port("unix:" + sys.argv[1])
server.start()
print("listens", flush=True)
server.wait_for_termination()
)");
  Command playmaker({python_, program, path}, {"PYTHONPATH=" + python_path()});
  ASSERT_TRUE(playmaker.wait_for_output("listens"));
  for (int seed = 1; seed <= seeds(); ++seed) {
    expect_same_match("unix:" + path, "mock", std::to_string(seed), name_);
  }
}

TEST_F(Batch, RecordingHoldsCallsOfAgents) {
  const std::string single = folder_.path() / "single.rpc";
  const std::string batch = folder_.path() / "batch.rpc";
  play("never", "mock", "mock:hold", "3", {"--record-rpc", single});
  play("always", "mock", "mock:hold", "3", {"--record-rpc", batch});
  for (const std::string& file : {single, batch}) {
    EXPECT_THAT(run({cls_binary(), "test", "--replay", file, "mock", "--json"}), Exits(0));
  }
}

TEST_F(Batch, OlderPlaymakerIsAskedForEachAgentWithoutWarning) {
  const std::string script = older();
  const Played played = play("auto", "mock:" + script, "mock", "1");
  EXPECT_EQ(played.result["warnings"], json::array());
  EXPECT_GT(played.result["left"]["players"][0]["decisions"], 100);
}

TEST_F(Batch, RequiredServiceThatIsMissingRefusesMatch) {
  const std::string script = older();
  EXPECT_THAT(run({cls_binary(), "match", "mock:" + script, "mock", "--batch", "always", "--cycles",
                   "10", "--dir", folder_.path() / "refused"}),
              Exits(69, HasSubstr("does not implement TeamPlaymaker")));
}

}  // namespace
}  // namespace cls::tests
