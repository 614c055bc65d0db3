// Connection losses and restarts of a Playmaker during a match: re-registration and missed
// decisions.
#include "proxy/playmaker/playmaker_client.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/index.h"
#include "proxy/agent/team.h"
#include "proxy/playmaker/grpc_playmaker.h"
#include "tests/proxy/agent/scripted_server.h"
#include "tests/proxy/playmaker/fake_playmaker.h"
#include "tests/proxy/playmaker/playmaker_server.h"

namespace cls::proxy {
namespace {

using namespace std::chrono_literals;
using tests::FakePlaymaker;
using tests::ScriptedServer;

constexpr int kHandshake = 22;  // calls, with 18 types

RpcStatus failure(RpcOutcome outcome, std::string message = "broken") {
  return {outcome, 1, std::move(message)};
}

/// A registered team of eleven.
struct Game {
  explicit Game(Playmaker& playmaker, TeamOptions options = named())
      : team(std::move(options), playmaker) {
    server.admit(team);
  }

  static TeamOptions named() {
    TeamOptions options;
    options.name = "us";
    return options;
  }

  void play_to(int last) {
    for (; cycle <= last; ++cycle) {
      server.send_cycle(cycle);
      EXPECT_EQ(team.run_cycle(), 11);
    }
  }
  const AgentStatistics& statistics(int unum) const {
    return team.players().at(base::index(unum - 1))->statistics();
  }
  int client_id(int unum) const {
    return team.players().at(base::index(unum - 1))->identity().client_id();
  }

  ScriptedServer server;
  Team team;
  int cycle = 1;
};

int calls_of(const FakePlaymaker& playmaker, const std::string& call) {
  return static_cast<int>(std::ranges::count(playmaker.calls(), call));
}

TEST(PlaymakerClient, ReregistersBeforeDecisionAfterConnectionLoss) {
  FakePlaymaker playmaker;
  std::vector<int> asked_by;
  playmaker.decide = [&](int agent, const protos::State& state, protos::PlayerActions&) {
    if (agent == 4) asked_by.push_back(state.register_response().client_id());
    return RpcStatus{};
  };
  Game game(playmaker);
  game.play_to(2);
  for (int unum = 1; unum <= 11; ++unum) playmaker.lost.insert(unum);
  const auto before = playmaker.calls().size();
  game.play_to(3);

  EXPECT_EQ(playmaker.calls().size() - before, 11U * (kHandshake + 1U));
  EXPECT_TRUE(playmaker.calls().back().starts_with("GetPlayerActions"));

  game.play_to(4);
  EXPECT_EQ(asked_by, (std::vector<int>{104, 104, 1104, 1104}));
  EXPECT_EQ(game.client_id(4), 1104);
  EXPECT_EQ(game.statistics(4).missed, 0);
  EXPECT_EQ(game.statistics(4).decisions, 4);
  EXPECT_EQ(game.statistics(4).reconnects, 1);
  EXPECT_EQ(game.team.take_warnings(),
            std::vector<std::string>{
                "connection to the Playmaker lost; players registered again at cycle 3"});
}

TEST(PlaymakerClient, RepeatsDecisionInSameCycleWhenConnectionIsLostDuringCall) {
  FakePlaymaker playmaker;
  bool broken = false;
  playmaker.decide = [&](int agent, const protos::State& state, protos::PlayerActions&) {
    if (agent != 6 || state.world_model().cycle() != 2 || std::exchange(broken, true)) {
      return RpcStatus{};
    }
    playmaker.lost.insert(agent);
    return failure(RpcOutcome::kUnavailable);
  };

  Game game(playmaker);
  game.play_to(3);

  EXPECT_EQ(game.statistics(6).decisions, 3);
  EXPECT_EQ(game.statistics(6).missed, 0);
  EXPECT_EQ(game.statistics(6).reconnects, 1);
  EXPECT_EQ(calls_of(playmaker, "GetPlayerActions 6"), 4);
  EXPECT_EQ(calls_of(playmaker, "Register 6"), 2);
  EXPECT_EQ(calls_of(playmaker, "Register 5"), 1) << "other agents are not registered again";
}

TEST(PlaymakerClient, ReregistersAfterUnavailableWithoutConnectionLoss) {
  FakePlaymaker playmaker;
  playmaker.decide = [](int, const protos::State& state, protos::PlayerActions&) {
    return state.world_model().cycle() == 2 ? failure(RpcOutcome::kUnavailable) : RpcStatus{};
  };
  Game game(playmaker);
  game.play_to(4);
  EXPECT_EQ(game.statistics(3).missed, 1);
  EXPECT_EQ(game.statistics(3).reconnects, 1);
  EXPECT_EQ(calls_of(playmaker, "Register 3"), 2);
}

TEST(PlaymakerClient, ReregistersAfterThreeConsecutiveErrorsThenAfterSix) {
  FakePlaymaker playmaker;
  playmaker.decide = [](int, const protos::State&, protos::PlayerActions&) {
    return failure(RpcOutcome::kError, "KeyError: 107");
  };
  Game game(playmaker);
  game.play_to(3);
  EXPECT_EQ(calls_of(playmaker, "Register 7"), 1);
  game.play_to(4);
  EXPECT_EQ(calls_of(playmaker, "Register 7"), 2);

  game.play_to(9);
  EXPECT_EQ(calls_of(playmaker, "Register 7"), 2);

  game.play_to(10);
  EXPECT_EQ(calls_of(playmaker, "Register 7"), 3);
  EXPECT_EQ(game.statistics(7).missed, 10);
  EXPECT_EQ(game.statistics(7).reconnects, 0) << "no successful decision since";
}

TEST(PlaymakerClient, SaysThatErrorsLedToTheRegistration) {
  FakePlaymaker playmaker;
  playmaker.decide = [](int, const protos::State& state, protos::PlayerActions&) {
    return state.world_model().cycle() <= 3 ? failure(RpcOutcome::kError) : RpcStatus{};
  };
  Game game(playmaker);
  game.play_to(6);

  EXPECT_EQ(game.statistics(7).reconnects, 1);
  EXPECT_THAT(
      game.team.take_warnings(),
      testing::Contains("3 errors of a player in a row; players registered again at cycle 4"));
}

TEST(PlaymakerClient, DoesNotReregisterAfterOccasionalErrors) {
  FakePlaymaker playmaker;
  playmaker.decide = [](int, const protos::State& state, protos::PlayerActions&) {
    return state.world_model().cycle() % 3 != 0 ? failure(RpcOutcome::kError) : RpcStatus{};
  };
  Game game(playmaker);
  game.play_to(12);
  EXPECT_EQ(calls_of(playmaker, "Register 7"), 1);
  EXPECT_EQ(game.statistics(7).missed, 8);
}

TEST(PlaymakerClient, DoesNotReregisterAfterDeadlinesAndMissingRpcs) {
  for (const RpcOutcome outcome :
       {RpcOutcome::kDeadline, RpcOutcome::kUnimplemented, RpcOutcome::kProtocolError}) {
    FakePlaymaker playmaker;
    playmaker.decide = [&](int, const protos::State&, protos::PlayerActions&) {
      return failure(outcome);
    };
    Game game(playmaker);
    game.play_to(8);
    EXPECT_EQ(calls_of(playmaker, "Register 7"), 1) << name(outcome);
    EXPECT_EQ(game.statistics(7).missed, 8);
  }
}

TEST(PlaymakerClient, MissesDecisionsUntilReregistrationSucceeds) {
  FakePlaymaker playmaker;
  bool closed = false;
  playmaker.handshake_status = [&](const std::string& method, int) {
    return closed && method == "Register" ? failure(RpcOutcome::kUnavailable, "unreachable")
                                          : RpcStatus{};
  };
  Game game(playmaker);
  game.play_to(1);
  for (int unum = 1; unum <= 11; ++unum) playmaker.lost.insert(unum);
  closed = true;
  game.play_to(4);

  EXPECT_EQ(game.statistics(2).missed, 3);
  EXPECT_EQ(game.team.missed_decisions().last.message, "unreachable");
  EXPECT_EQ(game.server.take(2).size(), 4U) << "the server still gets (done)";

  closed = false;
  game.play_to(5);

  EXPECT_EQ(game.statistics(2).missed, 3);
  EXPECT_EQ(game.statistics(2).consecutive_missed, 0);
  EXPECT_EQ(game.statistics(2).reconnects, 1);
}

TEST(PlaymakerClient, ContinuesHandshakeAfterDeadline) {
  FakePlaymaker playmaker;
  int types = 0;
  playmaker.handshake_status = [&](const std::string& method, int agent) {
    const bool late = agent == 9 && method == "SendPlayerType" && ++types == 18 + 5;
    return late ? failure(RpcOutcome::kDeadline, "too slow") : RpcStatus{};
  };
  Game game(playmaker);
  game.play_to(1);
  playmaker.lost.insert(9);
  game.play_to(2);

  EXPECT_EQ(game.statistics(9).missed, 1);
  EXPECT_EQ(game.statistics(9).late, 1);

  game.play_to(3);
  EXPECT_EQ(game.statistics(9).missed, 1);
  EXPECT_EQ(calls_of(playmaker, "Register 9"), 2);
  EXPECT_EQ(calls_of(playmaker, "SendPlayerType 9"), 18 + 18 + 1) << "the late call twice";
  EXPECT_EQ(game.client_id(9), 1109);
}

TEST(PlaymakerClient, ReregistersWithRestartedPlaymakerOfFirstInterface) {
  FakePlaymaker playmaker;
  playmaker.fail("Register", failure(RpcOutcome::kUnimplemented));
  Game game(playmaker);
  playmaker.lost.insert(5);
  game.play_to(2);
  EXPECT_EQ(game.statistics(5).missed, 0);
  EXPECT_EQ(game.client_id(5), 0);
  EXPECT_EQ(calls_of(playmaker, "SendInitMessage 5"), 2);
}

TEST(Team, WarnsWhenPlayersGetSameClientId) {
  tests::GameService service;
  service.on_register = [](const auto& request, protos::RegisterResponse& response) {
    response.set_client_id(7);
    response.set_uniform_number(request.uniform_number());
    return grpc::Status::OK;
  };

  tests::PlaymakerServer server(service);
  const auto playmaker = make_grpc_playmaker(server.in_process_channel(), "mock");
  Game game(*playmaker);
  const std::vector<std::string> expected = {
      "the Playmaker assigned players 1 and 2 the same client_id 7"};

  EXPECT_EQ(game.team.take_warnings(), expected);
  TeamOptions options = Game::named();
  options.shared_playmaker = false;
  Game other(*playmaker, options);
  EXPECT_TRUE(other.team.take_warnings().empty()) << "separate Playmakers may assign equal ids";
}

/// A Playmaker that assigns client ids from `first` and rejects unknown ones.
struct NumberingPlaymaker {
  explicit NumberingPlaymaker(int first) : next(first) {
    service.on_register = [this](const auto& request, protos::RegisterResponse& response) {
      response.set_client_id(next++);
      response.set_uniform_number(request.uniform_number());
      return grpc::Status::OK;
    };
    service.on_player = [this, first](const protos::State& state, protos::PlayerActions&) {
      const int id = state.register_response().client_id();
      const bool known = id >= first && id < next;
      return known ? grpc::Status::OK
                   : grpc::Status(grpc::StatusCode::UNKNOWN, "KeyError: " + std::to_string(id));
    };
  }
  tests::GameService service;
  std::atomic<int> next;
};

// The Playmaker restarts immediately, and after 300 ms; the server waits meanwhile.
TEST(PlaymakerClient, ReconnectsToRestartedProcessOverGrpc) {
  for (const auto gone_for : {0ms, 300ms}) {
    NumberingPlaymaker first(100);
    auto server = std::make_unique<tests::PlaymakerServer>(first.service);
    const int port = server->port();
    const auto playmaker = make_grpc_playmaker(tests::loopback(port));

    TeamOptions options = Game::named();
    options.reconnect_within = 30s;
    options.decision_timeout = 30s;
    Game game(*playmaker, options);
    game.play_to(3);
    server->stop();

    NumberingPlaymaker second(200);
    std::unique_ptr<tests::PlaymakerServer> again;
    std::thread starter([&] {
      std::this_thread::sleep_for(gone_for);
      again = std::make_unique<tests::PlaymakerServer>(second.service, port);
    });
    game.play_to(6);
    starter.join();

    for (int unum = 1; unum <= 11; ++unum) {
      EXPECT_EQ(game.statistics(unum).missed, 0) << game.statistics(unum).last_failure.message;
      EXPECT_EQ(game.statistics(unum).reconnects, 1);
      EXPECT_GE(game.client_id(unum), 200);
    }
    game.team.leave();
    EXPECT_EQ(second.service.calls().back(), "SendByeCommand 11");
  }
}

TEST(PlaymakerClient, WaitsOnceForProcessThatDoesNotRestart) {
  NumberingPlaymaker first(100);
  auto server = std::make_unique<tests::PlaymakerServer>(first.service);
  GrpcTarget target;
  target.host = "127.0.0.1";
  target.port = server->port();
  const auto playmaker = make_grpc_playmaker(target);
  TeamOptions options = Game::named();
  options.reconnect_within = 200ms;
  Game game(*playmaker, options);
  game.play_to(2);
  server->stop();
  game.play_to(5);

  EXPECT_EQ(game.statistics(1).missed, 3);

  const RpcStatus last = game.team.missed_decisions().last;
  EXPECT_EQ(last.outcome, RpcOutcome::kUnavailable) << last.message;
  EXPECT_EQ(game.statistics(1).late, 0);
}

}  // namespace
}  // namespace cls::proxy
