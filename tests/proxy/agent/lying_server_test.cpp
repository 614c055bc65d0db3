// Soccer servers and networks that lie to a team: nothing crashes or hangs, every datagram of the
// team stays one that a server can read, and what was unreadable is counted.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "mock-server/script/named_behaviors.h"
#include "mock-server/server.h"
#include "proxy/agent/team.h"
#include "proxy/playmaker/direct_playmaker.h"
#include "simulator/server/lockstep_server.h"
#include "soccer/commands/coach_command.h"
#include "soccer/commands/player_command.h"
#include "tests/proxy/agent/lying_channel.h"

namespace cls::proxy {
namespace {

using google::protobuf::Message;
using soccer::CoachRole;
using tests::Liar;
using tests::Lies;
using tests::LyingChannel;

constexpr int kLyingCycles = 60;
constexpr int kHonestCycles = 10;

/// True for what a server of any version reads from a player or coach.
bool is_readable(std::string_view datagram) {
  if (datagram.starts_with("(init ") || datagram.starts_with("(reconnect ")) return true;
  std::vector<soccer::PlayerCommand> commands;
  soccer::CoachCommand command;
  return !soccer::parse_player_commands(datagram, commands) ||
         !soccer::parse(datagram, CoachRole::kOnlineCoach, command);
}

/// A team of the mock on an honest server, and a liar between them.
class LyingServer : public testing::Test {
 protected:
  struct Outcome {
    bool joined = false;
    std::string refusal;  ///< why not
    std::int64_t messages = 0;
    std::int64_t told = 0;
    std::int64_t unreadable = 0;
    std::vector<std::int64_t> honest_decisions;  ///< of each player in the cycles after the lies
  };

  /// The liar begins with the first message, or when the team has joined.
  Outcome play(std::uint64_t seed, Lies lies, bool from_the_start) {
    Liar liar(seed);
    liar.on_send = [](std::string_view datagram) {
      EXPECT_TRUE(is_readable(datagram)) << datagram;
    };
    const auto server = make_server(seed);
    const auto foreigners = connect_foreigners(*server, liar);
    const auto mock =
        std::move(*mock_server::Server::start(std::move(*mock_server::make_behavior("simple"))));
    const auto playmaker =
        make_direct_playmaker([&mock](proto::Rpc rpc, const Message& request, Message& reply) {
          mock->handle(rpc, request, reply);
        });
    TeamOptions options;
    options.name = "honest";
    options.on_late = OnLate::kLast;
    Team team(options, *playmaker);
    if (from_the_start) liar.lies = lies;

    Outcome outcome;
    if (const auto joined = join(*server, team, liar); !joined) {
      outcome.refusal = joined.error().message;
      EXPECT_EQ(outcome.refusal.find('\n'), std::string::npos) << outcome.refusal;
      EXPECT_FALSE(outcome.refusal.empty());
    } else {
      outcome.joined = true;
      liar.lies = lies;
      run(*server, team, kLyingCycles);
      liar.lies = Lies::kNone;
      run(*server, team, 2);  // what was held back is delivered
      const std::vector<std::int64_t> before = decisions(team);
      run(*server, team, kHonestCycles);
      outcome.honest_decisions = decisions(team);
      for (std::size_t i = 0; i < before.size(); ++i) outcome.honest_decisions[i] -= before[i];
    }

    outcome.messages = liar.messages;
    outcome.told = liar.told;

    for (const auto& player : team.players()) {
      outcome.unreadable += player->server().errors.unreadable;
    }

    const simulator::World& world = server->world();
    EXPECT_TRUE(std::isfinite(world.ball.position.x) && std::isfinite(world.ball.velocity.y));

    team.leave();
    return outcome;
  }

 private:
  static std::unique_ptr<simulator::LockstepServer> make_server(std::uint64_t seed) {
    simulator::MatchConfig config;
    config.seed = seed;
    config.server.auto_mode = true;
    config.server.kick_off_wait = 2;
    config.server.connect_wait = 4;
    return std::move(*simulator::LockstepServer::create(config));
  }

  // Players of the other team, which only listen: one of each version that differs.
  static std::vector<std::unique_ptr<soccer::Channel>> connect_foreigners(
      simulator::LockstepServer& server, Liar& liar) {
    std::vector<std::unique_ptr<soccer::Channel>> channels;
    for (const int version : {1, 4, 6, 7, 8, 9, 13, 14, 17, 18, 19}) {
      channels.push_back(server.connect());
      channels.back()->send("(init Others (version " + std::to_string(version) + "))");
      server.accept_clients();
    }

    for (int cycle = 0; cycle < 2; ++cycle) server.run_cycle();
    for (const auto& channel : channels) {
      for (std::string message; channel->receive(message);) liar.foreign.push_back(message);
    }

    EXPECT_GT(liar.foreign.size(), 100U);
    return channels;
  }

  static base::Result<void> join(simulator::LockstepServer& server, Team& team, Liar& liar) {
    constexpr int kPatience = 30;
    int tries = 0;
    const auto serve = [&] {
      server.accept_clients();
      server.run_cycle();
      return ++tries % kPatience != 0;
    };
    const auto open = [&](simulator::ListeningPort port) {
      return std::make_unique<LyingChannel>(server.connect(port), liar);
    };

    if (auto done = team.connect([&] { return open(simulator::ListeningPort::kPlayers); }, serve);
        !done) {
      return done;
    }

    if (auto done = team.connect_coach(
            CoachRole::kOnlineCoach, [&] { return open(simulator::ListeningPort::kOnlineCoaches); },
            serve);
        !done) {
      return done;
    }

    const RpcStatus registered = team.register_agents();
    EXPECT_TRUE(registered.ok()) << registered.message;
    return {};
  }

  static void run(simulator::LockstepServer& server, Team& team, int cycles) {
    for (int i = 0; i < cycles; ++i) {
      server.run_cycle();
      team.run_cycle();
    }
  }

  static std::vector<std::int64_t> decisions(const Team& team) {
    std::vector<std::int64_t> all;
    for (const auto& player : team.players()) all.push_back(player->statistics().decisions);
    return all;
  }
};

// CLS_LYING_MESSAGES=1000000 plays until that many messages have passed a liar.
std::int64_t wanted_messages() {
  const char* text = std::getenv("CLS_LYING_MESSAGES");
  return text == nullptr ? 40'000 : std::atoll(text);
}

// The players decide again in every cycle as soon as the network is reliable.
TEST_F(LyingServer, TeamRecoversFromAFaultyNetwork) {
  std::int64_t messages = 0;
  std::int64_t told = 0;
  for (std::uint64_t seed = 1; messages < wanted_messages() && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Outcome outcome = play(seed, Lies::kNetwork, false);
    ASSERT_TRUE(outcome.joined) << outcome.refusal;
    for (const std::int64_t decisions : outcome.honest_decisions) {
      EXPECT_EQ(decisions, kHonestCycles);
    }
    EXPECT_GT(outcome.unreadable, 0) << "cut messages are counted";
    messages += outcome.messages;
    told += outcome.told;
  }

  std::printf("%lld messages, %lld lies\n", static_cast<long long>(messages),
              static_cast<long long>(told));
}

TEST_F(LyingServer, DoesNoHarmToATeamThatHasJoined) {
  std::int64_t messages = 0;
  for (std::uint64_t seed = 1; messages < wanted_messages() && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Outcome outcome = play(seed, Lies::kServer, false);
    ASSERT_TRUE(outcome.joined) << outcome.refusal;
    EXPECT_GT(outcome.unreadable, 0);
    messages += outcome.messages;
  }
}

// Most teams cannot join such a server, for a reason that is said in one line.
TEST_F(LyingServer, DoesNoHarmToATeamThatJoins) {
  std::int64_t messages = 0;
  int refused = 0;
  for (std::uint64_t seed = 1; messages < wanted_messages() / 4 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Outcome outcome = play(seed, Lies::kServer, true);
    messages += outcome.messages;
    if (!outcome.joined) ++refused;
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace cls::proxy
