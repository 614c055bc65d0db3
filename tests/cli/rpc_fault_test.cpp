// Full matches with a faulty Playmaker: the match continues, the result reports the fault, and the
// other side is unaffected. Each fault in lockstep and over UDP.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
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
using Arguments = std::vector<std::string>;

/// `cls mock hold` with faults, as a separate process.
class Mock {
 public:
  explicit Mock(Arguments flags, const std::string& port = "0") {
    flags.insert(flags.begin(), {cls_binary(), "mock", "hold", "--port", port});
    process_ = std::make_unique<Command>(flags);
    EXPECT_TRUE(process_->wait_for_output("\n"));
    const std::string line = process_->out();
    address_ = line.substr(13, line.find('\n') - 13);
  }
  const std::string& address() const { return address_; }
  std::string port() const { return address_.substr(address_.rfind(':') + 1); }
  Command& process() { return *process_; }

 private:
  std::unique_ptr<Command> process_;
  std::string address_;
};

struct Played {
  CommandResult command;
  json result;

  const json& player(int unum) const { return result["right"]["players"][unum - 1]; }
  std::int64_t total(const char* figure) const {
    std::int64_t sum = 0;
    for (const json& player : result["right"]["players"]) sum += player[figure].get<int>();
    return sum;
  }
  std::int64_t missed_by(const std::string& reason) const {
    std::int64_t sum = 0;
    for (const json& player : result["right"]["players"]) {
      sum += player["missed_by"].value(reason, 0);
    }
    return sum;
  }
  std::string warnings() const { return result["warnings"].dump(); }
};

class RpcFault : public testing::TestWithParam<const char*> {
 protected:
  /// The faulty Playmaker is on the right. The deadline is long, so that load causes no late
  /// replies.
  Arguments match(const std::string& right, const Arguments& more) const {
    Arguments argv = {cls_binary(),    "match",    "mock:hold", right,
                      "--mode",        GetParam(), "--cycles",  "34",
                      "--seed",        "7",        "--dir",     folder_.path() / "match",
                      "--stall-after", "60",       "--set",     "server::kick_off_wait=3"};
    if (std::ranges::find(more, "--rpc-deadline") == more.end()) {
      argv.insert(argv.end(), {"--rpc-deadline", "20000"});
    }
    for (const std::string& argument : more) argv.push_back(argument);
    return argv;
  }

  Played finish(CommandResult command) const {
    Played played{std::move(command), {}};
    const std::string file = folder_.path() / "match/result.json";
    played.result = json::parse(read_file(file));
    const json& left = played.result["left"]["players"];
    EXPECT_EQ(left.size(), 11U);
    for (const json& player : left) {
      EXPECT_EQ(player["missed"], 0) << "the other side is affected";
      EXPECT_EQ(player["reconnects"], 0);
      EXPECT_GT(player["decisions"], 10);
      EXPECT_FALSE(player["commands"].empty());
    }
    return played;
  }
  Played play(const std::string& right, const Arguments& more = {}) {
    return finish(run(match(right, more)));
  }
  Played play_mock(const Arguments& flags, const Arguments& more = {}) {
    const Mock mock(flags);
    return play(mock.address(), more);
  }

  static void expect_finished(const Played& played) {
    EXPECT_EQ(played.command.exit_code, 0) << played.command.err;
    EXPECT_EQ(played.result["end_reason"], "finished");
    EXPECT_GE(played.result["cycles"], 34);
  }
  static void expect_invalid(const Played& played, const std::string& reason) {
    EXPECT_EQ(played.command.exit_code, 1) << played.command.err;
    EXPECT_EQ(played.result["end_reason"], reason) << played.command.err;
    EXPECT_TRUE(played.result["winner"].is_null());
  }

  TemporaryFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(, RpcFault, testing::Values("lockstep", "synch"),
                         [](const auto& mode) { return std::string(mode.param); });

TEST_P(RpcFault, SlowRepliesChangeOnlyPercentiles) {
  const Played played = play_mock({"--delay", "4", "--jitter", "4"});
  expect_finished(played);
  EXPECT_EQ(played.total("missed"), 0);
  for (const json& player : played.result["right"]["players"]) {
    const json& us = player["rpc_us"];
    EXPECT_GE(us["p50"], 4000.0);
    EXPECT_GE(us["p95"], us["p50"]);
    EXPECT_GE(us["p99"], us["p95"]);
    EXPECT_GE(us["max"], us["p99"]);
  }
  EXPECT_THAT(played.command.out, HasSubstr("rpc p50 / p95"));
  EXPECT_THAT(played.command.out, HasSubstr("rpc worst p99 / max"));
}

TEST_P(RpcFault, EndsAsLateWithoutReplies) {
  const Played played =
      play_mock({"--drop", "1", "--fault-unum", "7", "--fault-cycles", "10", "10"},
                {"--rpc-deadline", "800"});
  expect_finished(played);
  EXPECT_GE(played.player(7)["late"], 1);
  EXPECT_EQ(played.player(7)["late"], played.player(7)["missed_by"]["deadline"]);
  EXPECT_EQ(played.player(7)["missed"], played.player(7)["late"]);
}

TEST_P(RpcFault, EndsAsLateWhenPlaymakerHangs) {
  const Played played =
      play_mock({"--hang-at-cycle", "15"}, {"--rpc-deadline", "400", "--max-missed", "2"});
  expect_invalid(played, "late");
  EXPECT_GE(played.missed_by("deadline"), 3);
  EXPECT_THAT(played.command.err, HasSubstr("had no usable reply to 3 calls in a row"));
}

TEST_P(RpcFault, RegistersPlayersAgainAfterPlaymakerRestart) {
  const Played played = play_mock({"--restart-at-cycle", "15", "--restart-after", "200"},
                                  {"--reconnect-within", "30", "--max-missed", "1000"});
  expect_finished(played);
  EXPECT_EQ(played.total("reconnects"), 11);
  EXPECT_EQ(played.total("late"), 0);
  EXPECT_THAT(played.warnings(), HasSubstr("connection to the Playmaker lost"));
  EXPECT_EQ(played.result["deterministic"], false);
}

TEST_P(RpcFault, ReconnectsAfterRestartAtHalfTime) {
  const Played played =
      play_mock({"--restart-at-cycle", "20", "--restart-after", "50"},
                {"--half-time", "2", "--reconnect-within", "30", "--max-missed", "1000"});
  expect_finished(played);
  EXPECT_EQ(played.total("reconnects"), 11);
}

TEST_P(RpcFault, ContinuesAfterPlaymakerProcessRestart) {
  Mock mock({"--crash-at-cycle", "15"});
  Command playing(match(mock.address(), {"--reconnect-within", "50", "--max-missed", "100000"}));
  mock.process().finish();
  const Mock again({}, mock.port());
  const Played played = finish(playing.finish(std::chrono::seconds(60)));
  expect_finished(played);
  EXPECT_EQ(played.total("reconnects"), 11);
}

TEST_P(RpcFault, ReportsCrashWhenPlaymakerProcessIsKilled) {
  const Played played =
      play_mock({"--crash-at-cycle", "15"}, {"--reconnect-within", "0.2", "--max-missed", "3"});
  expect_invalid(played, "crashed");
  EXPECT_GE(played.missed_by("unavailable"), 4);
  EXPECT_EQ(played.total("late"), 0);
}

TEST_P(RpcFault, CountsEachErrorStatusAsMissed) {
  GameService service;
  std::array<std::atomic<bool>, 17> reported{};  // each once
  service.on_player = [&](const protos::State& state, protos::PlayerActions&) {
    const int cycle = state.world_model().cycle();
    const auto code = static_cast<std::size_t>(cycle / 2);
    const bool due = state.register_response().uniform_number() == 5 && cycle % 2 == 0 &&
                     code >= 1 && code < reported.size() && !reported[code].exchange(true);
    return due ? grpc::Status(static_cast<grpc::StatusCode>(code), "on purpose") : grpc::Status::OK;
  };

  PlaymakerServer server(service);
  const Played played = play("127.0.0.1:" + std::to_string(server.port()));
  expect_finished(played);
  const json& player = played.player(5);

  EXPECT_EQ(player["missed"], 16) << player;
  EXPECT_EQ(player["missed_by"],
            json({{"deadline", 1}, {"error", 13}, {"unavailable", 1}, {"unimplemented", 1}}));
  EXPECT_EQ(played.total("missed"), 16);
}

TEST_P(RpcFault, AssumesFirstInterfaceWithoutRegister) {
  const Played played = play_mock({"--unimplemented", "Register,SendByeCommand"});
  expect_finished(played);
  EXPECT_EQ(played.total("missed"), 0);
  EXPECT_THAT(played.warnings(), HasSubstr("does not implement Register"));
}

TEST_P(RpcFault, AcceptsPlaymakerWithOnlyDecisions) {
  const Played played =
      play_mock({"--unimplemented",
                 "Register,SendByeCommand,SendServerParams,SendPlayerParams,SendPlayerType,"
                 "SendInitMessage,GetBestPlannerAction"});
  expect_finished(played);
  EXPECT_EQ(played.total("missed"), 0);
}

TEST_P(RpcFault, CountsInvalidReplyAsMissed) {
  const Played played =
      play_mock({"--garbage", "1", "--fault-unum", "5", "--fault-cycles", "10", "12"});
  expect_finished(played);
  EXPECT_EQ(played.player(5)["missed_by"], json({{"protocol error", 3}}));
  EXPECT_EQ(played.total("missed"), 3);
}

TEST_P(RpcFault, CountsReplyOfFiveMegabytesAsMissed) {
  const Played played =
      play_mock({"--oversize", "1", "--fault-unum", "5", "--fault-cycles", "10", "11"});
  expect_finished(played);
  EXPECT_EQ(played.player(5)["missed_by"], json({{"protocol error", 2}}));
  EXPECT_EQ(played.total("missed"), 2);
  EXPECT_THAT(played.warnings(), HasSubstr("bytes, more than the 1048576 that cls accepts"));
}

TEST_P(RpcFault, ReportsDuplicateClientIds) {
  const Played played = play_mock({"--wrong-client-id"});
  expect_finished(played);
  EXPECT_EQ(played.total("missed"), 0);
  EXPECT_THAT(played.warnings(), HasSubstr("the same client_id 1"));
}

TEST_P(RpcFault, OnLateSelectsSubstituteCommands) {
  GameService service;
  service.on_player = [](const protos::State& state, protos::PlayerActions& actions) {
    const bool refused =
        state.register_response().uniform_number() == 9 && state.world_model().cycle() >= 12;
    actions.set_ignore_preprocess(true);
    actions.add_actions()->mutable_dash()->set_power(40.0F);
    return refused ? grpc::Status(grpc::StatusCode::UNKNOWN, "no idea") : grpc::Status::OK;
  };

  PlaymakerServer server(service);
  const auto dashes = [&](const char* on_late) {
    const Played played = play("127.0.0.1:" + std::to_string(server.port()),
                               {"--on-late", on_late, "--max-missed", "100"});
    expect_finished(played);
    EXPECT_GT(played.player(9)["missed"], 20) << on_late;
    std::filesystem::remove_all(folder_.path() / "match");
    return played.player(9)["commands"].value("dash", 0);
  };
  const int hold = dashes("hold");
  const int default_count = dashes("default");
  const int last = dashes("last");

  EXPECT_GE(hold, 10) << "before the connection was refused";
  EXPECT_GT(default_count, hold) << "moves back to its position in the formation";
  EXPECT_GE(last, hold + 20);
}

// In real time the server does not wait: late decisions are missed, and both sides continue.
TEST(RpcFaultInRealTime, CountsSlowRepliesAndRestart) {
  const auto play = [](const Arguments& flags, const Arguments& more) {
    const TemporaryFolder folder;
    const Mock mock(flags);
    Played played{run(joined({cls_binary(), "match", "mock:hold", mock.address(), "--mode",
                              "realtime", "--cycles", "25", "--seed", "7", "--max-missed", "1000",
                              "--dir", folder.path(), "--set", "server::kick_off_wait=3"},
                             more)),
                  {}};
    played.result = json::parse(read_file(folder.path() / "result.json"));
    EXPECT_EQ(played.command.exit_code, 0) << played.command.err;
    return played;
  };
  const Played slow =
      play({"--delay", "150", "--fault-unum", "3", "--fault-cycles", "5", "15"}, {});

  EXPECT_GE(slow.player(3)["late"], 3);
  EXPECT_GT(slow.player(3)["decisions"], slow.player(3)["late"]);

  const Played restarted = play({"--restart-at-cycle", "8", "--restart-after", "300"}, {});
  EXPECT_GE(restarted.total("reconnects"), 11);
  EXPECT_GE(restarted.missed_by("unavailable"), 1);
}

}  // namespace
}  // namespace cls::tests
