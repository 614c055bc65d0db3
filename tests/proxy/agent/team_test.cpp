// A team from connecting and registration to decisions, failures and leaving.
#include "proxy/agent/team.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "base/index.h"
#include "proxy/playmaker/grpc_playmaker.h"
#include "soccer/protocol/scanner.h"
#include "tests/proxy/agent/scripted_server.h"
#include "tests/proxy/playmaker/fake_playmaker.h"
#include "tests/proxy/playmaker/playmaker_server.h"
#include "tests/support/files.h"

namespace cls::proxy {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using tests::FakePlaymaker;
using tests::ScriptedServer;
using Said = std::vector<std::string>;

TeamOptions options(OnLate on_late = OnLate::kHold) {
  TeamOptions options;
  options.name = "us";
  options.on_late = on_late;
  return options;
}

base::Result<void> connect(Team& team, ScriptedServer& server) {
  return team.connect([&] { return server.open(); },
                      [&, tries = 0]() mutable {
                        server.serve();
                        return ++tries % 4 != 0;
                      });
}

RpcStatus failure(RpcOutcome outcome, std::string message = "") {
  return {outcome, 1, std::move(message)};
}

/// A team of eleven connected to `server` and registered.
struct Game {
  explicit Game(FakePlaymaker& playmaker, OnLate on_late = OnLate::kHold)
      : team(options(on_late), playmaker) {
    server.admit(team);
  }

  ScriptedServer server;
  Team team;
};

/// Datagrams of the eleven players over some cycles with decisions that depend on the State.
std::vector<Said> play(FakePlaymaker& playmaker, int cycles) {
  playmaker.decide = [](int agent, const protos::State& state, protos::PlayerActions& actions) {
    actions.add_actions()->mutable_dash()->set_power(
        static_cast<float>(agent + state.world_model().cycle()));
    actions.add_actions()->mutable_turn_neck()->set_moment(static_cast<float>(agent));
    return RpcStatus{};
  };

  Game game(playmaker);
  for (int cycle = 1; cycle <= cycles; ++cycle) {
    game.server.send_cycle(cycle);
    EXPECT_EQ(game.team.run_cycle(), 11);
  }

  std::vector<Said> said;
  for (int unum = 1; unum <= 11; ++unum) said.push_back(game.server.take(unum));
  return said;
}

/// RPCs of an agent in the recorded match, in sequence.
std::vector<std::string> recorded_life(const std::string& agent) {
  std::istringstream lines(tests::read_file(*tests::data("aligned/grpc/index.tsv.gz")));
  std::vector<std::string> methods;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream columns(line);
    std::string time;
    std::string who;
    std::string method;
    columns >> time >> who >> method;
    if (who == agent) methods.push_back(method);
  }
  return methods;
}

std::vector<std::string> life_of(const FakePlaymaker& playmaker, int agent) {
  std::vector<std::string> methods;
  const std::string suffix = " " + std::to_string(agent);
  for (const std::string& call : playmaker.calls()) {
    if (call.size() > suffix.size() && call.substr(call.size() - suffix.size()) == suffix) {
      methods.push_back(call.substr(0, call.size() - suffix.size()));
    }
  }
  return methods;
}

TEST(Team, CallsInSequenceOfUpstreamProxy) {
  if (!tests::data("aligned/grpc/index.tsv.gz")) GTEST_SKIP() << "no data: set CLS_DATA";
  for (const int agent : {1, 4}) {
    const std::vector<std::string> recorded = recorded_life(std::to_string(agent));
    ASSERT_GT(recorded.size(), 100U);
    const auto decisions = std::ranges::count(recorded, "GetPlayerActions");
    FakePlaymaker playmaker;
    Game game(playmaker);
    for (int cycle = 1; cycle <= decisions; ++cycle) {
      game.server.send_cycle(cycle);
      game.team.run_cycle();
    }
    game.team.leave();
    EXPECT_EQ(life_of(playmaker, agent), recorded);
  }
}

TEST(Team, RegistersPlayersSequentiallyGoalieFirst) {
  FakePlaymaker playmaker;
  Game game(playmaker);
  std::vector<std::string> registered;
  for (const std::string& call : playmaker.calls()) {
    if (call.starts_with("Register")) registered.push_back(call);
  }

  ASSERT_EQ(registered.size(), 11U);
  EXPECT_EQ(registered.front(), "Register 1");
  EXPECT_EQ(registered.back(), "Register 11");
  EXPECT_EQ(playmaker.calls().size(), 11U * 22U);

  const auto& players = game.team.players();
  EXPECT_TRUE(players.front()->options().goalie);
  EXPECT_FALSE(players.back()->options().goalie);
  EXPECT_EQ(players.back()->identity().client_id(), 111);
}

TEST(Team, RequestsAllDecisionsBeforeWaiting) {
  FakePlaymaker playmaker;
  play(playmaker, 3);
  EXPECT_EQ(playmaker.max_outstanding(), 11U);
}

TEST(Team, SendsSameCommandsForAnyOrderOfReplies) {
  FakePlaymaker in_order;
  FakePlaymaker reversed;
  FakePlaymaker mixed;
  reversed.order = [](const auto& outstanding) { return outstanding.size() - 1; };
  mixed.order = [n = std::size_t{0}](const auto& outstanding) mutable {
    n += 7;
    return n % outstanding.size();
  };
  const std::vector<Said> said = play(in_order, 20);

  ASSERT_EQ(said.at(3).size(), 20U);
  EXPECT_THAT(said.at(3).at(4), HasSubstr("(done)"));
  EXPECT_EQ(play(reversed, 20), said);
  EXPECT_EQ(play(mixed, 20), said);
}

TEST(Team, SendsCommandsOfCycleAndDoneInOneDatagram) {
  FakePlaymaker playmaker;
  const std::vector<Said> said = play(playmaker, 1);
  ASSERT_EQ(said.at(6).size(), 1U);
  EXPECT_THAT(said.at(6).front(), StartsWith("(dash 8)(turn_neck 7)"));
  EXPECT_THAT(said.at(6).front(), HasSubstr("(done)"));
}

TEST(Team, RequestsDecisionsOnlyAfterThink) {
  FakePlaymaker playmaker;
  Game game(playmaker);
  game.server.send_cycle(1, false);
  EXPECT_EQ(game.team.run_cycle(), 0);
  game.server.send(5, "(think)");
  EXPECT_EQ(game.team.run_cycle(), 1);
  EXPECT_EQ(playmaker.calls().back(), "GetPlayerActions 5");
  EXPECT_EQ(game.server.take(5).size(), 1U);
  EXPECT_TRUE(game.server.take(6).empty());
}

TEST(Team, CountsMissedDecisionsAndStillSendsDone) {
  FakePlaymaker playmaker;
  const std::map<int, RpcOutcome> outcomes = {
      {2, RpcOutcome::kDeadline}, {3, RpcOutcome::kUnavailable}, {4, RpcOutcome::kProtocolError}};
  playmaker.decide = [&](int agent, const protos::State& state, protos::PlayerActions&) {
    const auto found = outcomes.find(agent);
    const bool recovered = state.world_model().cycle() > 3;
    return found == outcomes.end() || recovered ? RpcStatus{} : failure(found->second, "broken");
  };

  Game game(playmaker);
  for (int cycle = 1; cycle <= 3; ++cycle) {
    game.server.send_cycle(cycle);
    EXPECT_EQ(game.team.run_cycle(), 11);
  }
  EXPECT_EQ(game.team.missed_decisions().consecutive, 3);
  EXPECT_EQ(game.team.missed_decisions().last.message, "broken");

  const auto& late = game.team.players().at(1)->statistics();
  EXPECT_EQ(late.decisions, 3);
  EXPECT_EQ(late.late, 3);
  EXPECT_EQ(late.missed, 3);
  EXPECT_EQ(late.rpc_us.size(), 0U);

  const auto& dead = game.team.players().at(2)->statistics();
  EXPECT_EQ(dead.late, 0);
  EXPECT_EQ(dead.missed, 3);
  EXPECT_EQ(dead.outcomes.at(base::index(RpcOutcome::kUnavailable)), 3);

  for (const auto& [agent, outcome] : outcomes) {
    const Said said = game.server.take(agent);
    ASSERT_EQ(said.size(), 3U);
    EXPECT_THAT(said.back(), HasSubstr("(done)"));
  }
  game.server.send_cycle(4);
  game.team.run_cycle();

  EXPECT_EQ(game.team.missed_decisions().consecutive, 0);
  EXPECT_EQ(late.max_consecutive_missed, 3);
  EXPECT_EQ(late.rpc_us.percentile(0.5), 20.0);
}

TEST(Team, FollowsOnLateOption) {
  const auto said_late = [](OnLate on_late) {
    FakePlaymaker playmaker;
    playmaker.decide = [](int, const protos::State& state, protos::PlayerActions& actions) {
      actions.set_ignore_preprocess(true);
      actions.add_actions()->mutable_dash()->set_power(33.0F);
      return state.world_model().cycle() >= 2 ? failure(RpcOutcome::kDeadline) : RpcStatus{};
    };

    Game game(playmaker, on_late);
    for (int cycle = 1; cycle <= 2; ++cycle) {
      game.server.send_cycle(cycle);
      game.team.run_cycle();
    }

    const Said said = game.server.take(8);
    EXPECT_EQ(said.size(), 2U);
    EXPECT_THAT(said.front(), HasSubstr("(dash 33)"));
    return said.back();
  };

  EXPECT_THAT(said_late(OnLate::kHold), Not(HasSubstr("dash")));
  EXPECT_THAT(said_late(OnLate::kLast), HasSubstr("(dash 33)"));

  const std::string by_itself = said_late(OnLate::kDefault);
  EXPECT_THAT(by_itself, Not(HasSubstr("(dash 33)")));
  EXPECT_THAT(by_itself, HasSubstr("(done)"));
  EXPECT_NE(by_itself, said_late(OnLate::kHold));
}

TEST(Team, PlaysWithPlaymakerOfFirstInterface) {
  FakePlaymaker playmaker;
  playmaker.handshake_status = [](const std::string& method, int) {
    return method == "Register" || method == "SendByeCommand" ? failure(RpcOutcome::kUnimplemented)
                                                              : RpcStatus{};
  };
  ScriptedServer server;
  Team team(options(), playmaker);

  ASSERT_TRUE(connect(team, server));
  ASSERT_TRUE(team.register_agents().ok());
  EXPECT_EQ(team.players().at(4)->identity().client_id(), 0);
  EXPECT_EQ(team.players().at(4)->identity().uniform_number(), 5);
  EXPECT_EQ(team.players().at(4)->identity().team_name(), "us");
  EXPECT_EQ(team.take_warnings().size(), 1U);

  server.send_cycle(1);
  EXPECT_EQ(team.run_cycle(), 11);
  EXPECT_EQ(team.missed_decisions().unum, 0);
}

TEST(Team, NamesPlayerWhosePlaymakerIsUnreachable) {
  FakePlaymaker playmaker;
  playmaker.fail("Register", failure(RpcOutcome::kUnavailable, "unreachable"), 3);
  ScriptedServer server;
  Team team(options(), playmaker);
  ASSERT_TRUE(connect(team, server));
  const RpcStatus status = team.register_agents();
  EXPECT_EQ(status.outcome, RpcOutcome::kUnavailable);
  EXPECT_EQ(status.message, "player 3: unreachable");
}

TEST(Team, ToleratesErrorsOfParameterCalls) {
  FakePlaymaker playmaker;
  playmaker.fail("SendPlayerType", failure(RpcOutcome::kError, "SendPlayerType: oops"));
  ScriptedServer server;
  Team team(options(), playmaker);
  ASSERT_TRUE(connect(team, server));
  EXPECT_TRUE(team.register_agents().ok());
  EXPECT_EQ(team.take_warnings(), Said{"SendPlayerType: oops"});
  EXPECT_TRUE(team.take_warnings().empty());
}

TEST(Team, ReportsRefusalOfSoccerServer) {
  FakePlaymaker playmaker;
  ScriptedServer server;
  server.refusal = "(error no_more_team_or_player_or_goalie)";
  Team team(options(), playmaker);
  const base::Result<void> done = connect(team, server);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().message,
            "us, player 1: rejected by the soccer server: no_more_team_or_player_or_goalie");
}

TEST(Team, ReportsMissingReplyOfSoccerServer) {
  FakePlaymaker playmaker;
  ScriptedServer server;
  Team team(options(), playmaker);
  const base::Result<void> done = team.connect([&] { return server.open(); }, [] { return false; });
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message, HasSubstr("no reply from the soccer server"));
}

TEST(Team, RejectsServerThatGivesANumberTwice) {
  FakePlaymaker playmaker;
  ScriptedServer server;
  server.only_unum = 3;
  Team team(options(), playmaker);
  const base::Result<void> done = connect(team, server);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().message,
            "us, player 2: the soccer server gave it number 3, which another player has");
}

// As a duplicated datagram does, or a server that fails.
TEST(Team, ContinuesAfterSecondReplyToInit) {
  for (const char* second : {"(init l 2 before_kick_off)", "(init r 9 play_on)"}) {
    FakePlaymaker playmaker;
    Game game(playmaker);
    for (int cycle = 1; cycle <= 3; ++cycle) {
      game.server.send(2, second);
      game.server.send_cycle(cycle);
      EXPECT_EQ(game.team.run_cycle(), 11) << second;
    }
    EXPECT_EQ(game.team.players()[1]->world().our_side, soccer::Side::kLeft);
    const Said warnings = game.team.take_warnings();
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings.front(), HasSubstr(second));
  }
}

TEST(Team, HandlesCycleThatIsFarAheadQuickly) {
  FakePlaymaker playmaker;
  Game game(playmaker);
  game.server.send_cycle(1);
  EXPECT_EQ(game.team.run_cycle(), 11);
  const auto begin = std::chrono::steady_clock::now();
  game.server.send_cycle(soccer::kMaxInteger);
  EXPECT_EQ(game.team.run_cycle(), 11);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST(Team, SendsByeToPlaymakerAndServer) {
  FakePlaymaker playmaker;
  Game game(playmaker);
  game.team.leave();
  const auto& calls = playmaker.calls();
  EXPECT_EQ(std::vector<std::string>(calls.end() - 2, calls.end()),
            (std::vector<std::string>{"SendByeCommand 10", "SendByeCommand 11"}));
  EXPECT_EQ(game.server.take(9), Said{"(bye)"});
}

TEST(Team, SendsByeOnlyForRegisteredPlayers) {
  FakePlaymaker playmaker;
  playmaker.fail("Register", failure(RpcOutcome::kDeadline), 3);
  ScriptedServer server;
  Team team(options(), playmaker);
  ASSERT_TRUE(connect(team, server));
  ASSERT_FALSE(team.register_agents().ok());

  team.leave();
  const auto& calls = playmaker.calls();

  EXPECT_EQ(std::vector<std::string>(calls.end() - 2, calls.end()),
            (std::vector<std::string>{"SendByeCommand 1", "SendByeCommand 2"}));
  EXPECT_EQ(server.take(11).back(), "(bye)");
}

TEST(Team, WaitsOnceForHangingPlaymakerOnLeave) {
  FakePlaymaker playmaker;
  playmaker.fail("SendByeCommand", failure(RpcOutcome::kDeadline));
  Game game(playmaker);
  game.team.leave();
  EXPECT_EQ(playmaker.calls().back(), "SendByeCommand 1");
  EXPECT_EQ(game.server.take(11), Said{"(bye)"});
}

TEST(Team, WarnsOnceOfUnreadableServerMessages) {
  FakePlaymaker playmaker;
  Game game(playmaker);
  for (int cycle = 1; cycle <= 2; ++cycle) {
    game.server.send(2, "(see 1 ((b) nonsense");
    game.server.send_cycle(cycle);
    game.team.run_cycle();
  }
  const Said warnings = game.team.take_warnings();
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings.front(), HasSubstr("(see 1 ((b) nonsense"));
}

TEST(Team, CountsCommandsByKind) {
  FakePlaymaker playmaker;
  playmaker.decide = [](int, const auto&, protos::PlayerActions& actions) {
    actions.add_actions()->mutable_dash()->set_power(50.0F);
    return RpcStatus{};
  };

  Game game(playmaker);
  for (int cycle = 1; cycle <= 4; ++cycle) {
    game.server.send_cycle(cycle);
    game.team.run_cycle();
  }

  const auto commands = game.team.players().at(6)->statistics().commands_by_name();
  EXPECT_EQ(commands.at("dash"), 4);
  EXPECT_EQ(commands.count("done"), 0U);
  EXPECT_EQ(commands.count("kick"), 0U);
}

TEST(Team, PlaysOverGrpcAndContinuesAfterPlaymakerStops) {
  tests::GameService service;
  service.on_player = [](const auto&, protos::PlayerActions& actions) {
    actions.add_actions()->mutable_dash()->set_power(60.0F);
    return grpc::Status::OK;
  };

  tests::PlaymakerServer server_of_playmaker(service);
  GrpcTarget target;
  target.host = "127.0.0.1";
  target.port = server_of_playmaker.port();
  const auto playmaker = make_grpc_playmaker(target);
  ScriptedServer server;
  Team team(options(), *playmaker);
  ASSERT_TRUE(connect(team, server));
  const RpcStatus introduced = team.register_agents();
  ASSERT_TRUE(introduced.ok()) << name(introduced.outcome) << introduced.message;

  for (int cycle = 1; cycle <= 5; ++cycle) {
    server.send_cycle(cycle);
    EXPECT_EQ(team.run_cycle(), 11);
  }
  const AgentStatistics& statistics = team.players().at(0)->statistics();
  EXPECT_EQ(statistics.decisions, 5);
  EXPECT_EQ(statistics.missed, 0);
  EXPECT_GT(statistics.rpc_us.percentile(0.99), 0.0);
  EXPECT_GE(statistics.rpc_us.max(), statistics.rpc_us.percentile(0.5));

  server_of_playmaker.stop();
  for (int cycle = 6; cycle <= 8; ++cycle) {
    server.send_cycle(cycle);
    EXPECT_EQ(team.run_cycle(), 11);
  }
  EXPECT_EQ(team.missed_decisions().consecutive, 3);
  EXPECT_EQ(team.missed_decisions().last.outcome, RpcOutcome::kUnavailable);
  team.leave();
  EXPECT_EQ(server.take(11).back(), "(bye)");
}

}  // namespace
}  // namespace cls::proxy
