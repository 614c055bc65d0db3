// Playmakers that stop replying: whichever limit expires, the result names side, player and RPC.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/proxy/playmaker/playmaker_server.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;
using testing::Not;

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

struct Played {
  CommandResult command;
  json result;
};

// `right` plays against the mock.
Played play_against(const std::string& right, const std::vector<std::string>& more) {
  const TemporaryFolder folder;
  const std::vector<std::string> arguments =
      joined({cls_binary(), "match", "mock", right, "--right-name", "hangs", "--seed", "7", "--set",
              "server::kick_off_wait=3", "--dir", folder.path()},
             more);
  Played played;
  played.command = run(arguments);
  played.result = json::parse(read_file(folder.path() / "result.json"));
  return played;
}

Played play_with_faults(const std::string& faults, const std::vector<std::string>& more) {
  const TemporaryFolder folder;
  const auto script = folder.path() / "script.json";
  write_file(script, R"({"otherwise": "simple", "faults": )" + faults + "}");
  return play_against("mock:" + script.string(), more);
}

void expect_blamed(const Played& played, const std::string& end_reason, const std::string& rpc,
                   const std::string& agent) {
  const json& result = played.result;
  EXPECT_EQ(result["end_reason"], end_reason) << played.command.err;
  EXPECT_EQ(result["fault"], "right") << result.dump(1);
  ASSERT_TRUE(result["failure"].is_object()) << played.command.err;
  EXPECT_EQ(result["failure"]["process"], "right Playmaker");
  EXPECT_EQ(result["failure"]["rpc"], rpc);
  const std::string awaited = rpc + " of " + agent;
  EXPECT_THAT(result["message"].get<std::string>(), HasSubstr(awaited)) << result["message"];
  EXPECT_THAT(played.command.err, HasSubstr(awaited));
  EXPECT_THAT(played.command.err, HasSubstr("cls: hangs ("));
}

// Deadline and stall limit may be equal or nearly so: both must lead to the same end.
class EqualLimits : public testing::TestWithParam<const char*> {};

TEST_P(EqualLimits, BlameTheSideThatHangs) {
  const Played played = play_with_faults(R"({"hang_at_cycle": 3})",
                                         {"--rpc-deadline", GetParam(), "--stall-after", "2"});
  expect_blamed(played, "stalled", "GetPlayerActions", "player 1 and 11 other agents");
  EXPECT_THAT(played.command.err,
              HasSubstr("11 other agents (one call; --batch never names the player) at cycle 3"));
  EXPECT_EQ(played.result["failure"]["unum"], 1);
  EXPECT_EQ(played.result["failure"]["cycle"], 3);
  EXPECT_THAT(played.command.err, HasSubstr("at cycle 3"));
}

INSTANTIATE_TEST_SUITE_P(Hangs, EqualLimits, testing::Values("2000", "2001", "9000"));

TEST(Hangs, EndAsLateWithShortDeadline) {
  const Played played =
      play_with_faults(R"({"hang_at_cycle": 3})",
                       {"--rpc-deadline", "50", "--max-missed", "3", "--stall-after", "10"});
  EXPECT_EQ(played.result["end_reason"], "late");
  EXPECT_EQ(played.result["fault"], "right");
  EXPECT_EQ(played.result["failure"]["process"], "right Playmaker");
  EXPECT_THAT(played.command.err, HasSubstr("player 1 had no usable reply"));
}

TEST(Hangs, BlameTheCoach) {
  const Played played = play_with_faults(R"({"drop": 1.0, "only": {"unum": [12]}})",
                                         {"--batch", "never", "--stall-after", "2"});
  expect_blamed(played, "stalled", "GetCoachActions", "the coach");
  EXPECT_EQ(played.result["failure"]["unum"], 12);
}

TEST(Hangs, BlameThePlannersChoice) {
  class Service : public GameService {
   public:
    std::atomic<bool> over{false};
    grpc::Status GetBestPlannerAction(grpc::ServerContext* /*context*/,
                                      const protos::BestPlannerActionRequest* /*request*/,
                                      protos::BestPlannerActionResponse* /*response*/) override {
      while (!over) std::this_thread::sleep_for(std::chrono::milliseconds(20));
      return grpc::Status::OK;
    }
  };

  Service service;
  service.on_player = [](const protos::State& state, protos::PlayerActions& actions) {
    if (state.world_model().self().is_kickable()) {
      actions.add_actions()->mutable_helios_offensive_planner()->set_server_side_decision(true);
    } else {
      actions.add_actions()->mutable_body_intercept();
    }
    return grpc::Status::OK;
  };

  PlaymakerServer server(service);
  const Played played = play_against("127.0.0.1:" + std::to_string(server.port()),
                                     {"--stall-after", "2", "--cycles", "600"});
  service.over = true;
  expect_blamed(played, "stalled", "GetBestPlannerAction", "player ");
}

TEST(Hangs, BlameRegisterAtTheStart) {
  GameService service;
  std::atomic<bool> over{false};
  service.on_register = [&](const protos::RegisterRequest& request, protos::RegisterResponse&) {
    while (request.uniform_number() == 4 && !over) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return grpc::Status::OK;
  };
  PlaymakerServer server(service);
  const Played played =
      play_against("127.0.0.1:" + std::to_string(server.port()), {"--start-timeout", "4"});
  over = true;
  expect_blamed(played, "refused", "Register", "player 4");
  EXPECT_TRUE(played.result["failure"]["cycle"].is_null());
  EXPECT_THAT(played.command.err, HasSubstr("within the start limit of 4 s"));
}

TEST(Hangs, BlameTheSideOverUdp) {
  const Played played = play_with_faults(
      R"({"hang_at_cycle": 3})",
      {"--mode", "synch", "--rpc-deadline", "2000", "--stall-after", "2", "--cycles", "100"});
  expect_blamed(played, "stalled", "GetPlayerActions", "player ");
}

TEST(Hangs, BlameRegisterOverUdp) {
  GameService service;
  std::atomic<bool> over{false};
  service.on_register = [&](const protos::RegisterRequest&, protos::RegisterResponse&) {
    while (!over) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return grpc::Status::OK;
  };
  PlaymakerServer server(service);
  const Played played = play_against("127.0.0.1:" + std::to_string(server.port()),
                                     {"--mode", "synch", "--start-timeout", "8"});
  over = true;
  expect_blamed(played, "refused", "Register", "player 1");
}

// The players leave because the match has ended: it is not reported.
TEST(Hangs, EndInRealTimeWithoutALineForEachPlayer) {
  const Played played =
      play_with_faults(R"({"delay_ms": 300})", {"--mode", "realtime", "--max-missed", "5"});
  EXPECT_EQ(played.result["end_reason"], "late") << played.command.err;
  EXPECT_EQ(played.result["fault"], "right");
  EXPECT_THAT(played.command.err, Not(HasSubstr("left the match")));
}

TEST(Hangs, NameBothSidesWhenBothHang) {
  const TemporaryFolder folder;
  const auto script = folder.path() / "script.json";
  write_file(script, R"({"otherwise": "simple", "faults": {"hang_at_cycle": 3}})");
  const auto command = run({cls_binary(), "match", "mock:" + script.string(),
                            "mock:" + script.string(), "--stall-after", "2", "--set",
                            "server::kick_off_wait=3", "--dir", folder.path() / "match"});
  const json result = json::parse(read_file(folder.path() / "match" / "result.json"));
  EXPECT_EQ(result["end_reason"], "stalled");
  EXPECT_TRUE(result["fault"].is_null());
  EXPECT_THAT(command.err, HasSubstr("script_l ("));
  EXPECT_THAT(command.err, HasSubstr("; script_r ("));
}

TEST(Hangs, AreForfeitedInTournaments) {
  const TemporaryFolder folder;
  const auto script = folder.path() / "script.json";
  write_file(script, R"({"otherwise": "simple", "faults": {"hang_at_cycle": 3}})");
  const auto ran = run({cls_binary(), "tournament", "run", folder.path() / "cup", "--team",
                        "OK=mock", "--team", "HANG=mock:" + script.string(), "--cycles", "30",
                        "--on-crash", "forfeit", "--stall-after", "2", "--rpc-deadline", "2000"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  const auto report =
      run({cls_binary(), "tournament", "report", folder.path() / "cup", "--format", "json"});
  const json document = json::parse(report.out);
  ASSERT_EQ(document["matches"].size(), 2u);
  for (const json& match : document["matches"]) {
    const bool left_hangs = match["left"] == "HANG";
    EXPECT_EQ(match["score"], left_hangs ? json({0, 3}) : json({3, 0})) << match.dump(1);
  }
}

}  // namespace
}  // namespace cls::tests
