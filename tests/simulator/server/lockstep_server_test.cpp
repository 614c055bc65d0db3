// Matches of scripted players on LockstepServer.
#include "simulator/server/lockstep_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/io/byte_sink.h"
#include "simulator/actions/actions.h"
#include "simulator/step.h"
#include "tests/support/rcg_lines.h"
#include "tests/support/scripted_player.h"

namespace cls::simulator {
namespace {

using testing::HasSubstr;
using tests::ScriptedPlayer;

MatchConfig quick_match(std::uint64_t seed = 7) {
  MatchConfig config;
  config.seed = seed;
  config.server.auto_mode = true;
  config.server.kick_off_wait = 5;
  config.server.half_time = 20;
  config.server.nr_extra_halfs = 0;
  config.server.penalty_shoot_outs = false;
  return config;
}

/// A server with scripted players and both logs in memory.
struct Match {
  explicit Match(const MatchConfig& config, int players = soccer::kPlayersPerTeam,
                 int version = 18) {
    server = std::move(*LockstepServer::create(config));
    server->record(&game_log, &text_log);
    const auto places = tests::formation(true);
    for (const char* team : {"Left", "Right"}) {
      for (int i = 0; i < players; ++i) {
        auto& player = *clients.emplace_back(
            std::make_unique<ScriptedPlayer>(server->connect(), team, version));
        player.stand_at(places[static_cast<std::size_t>(i)]);
        player.join(i == 0);
        server->accept_clients();
        player.act();
      }
    }
  }

  void run_cycle() {
    server->run_cycle();
    for (auto& client : clients) client->act();
  }

  void run_to_end() {
    while (!server->finished()) run_cycle();
    server->finish();
  }

  ScriptedPlayer& first() { return *clients.front(); }

  base::StringSink game_log;
  base::StringSink text_log;
  std::unique_ptr<LockstepServer> server;
  std::vector<std::unique_ptr<ScriptedPlayer>> clients;
};

std::vector<std::string> referee_lines(const Match& match) {
  std::vector<std::string> lines;
  for (const auto line : tests::split_lines(match.text_log.bytes())) {
    if (line.find("\t(referee ") != std::string_view::npos) lines.emplace_back(line);
  }
  return lines;
}

bool contains(const std::vector<std::string>& lines, std::string_view part) {
  return std::any_of(lines.begin(), lines.end(), [part](const std::string& line) {
    return line.find(part) != std::string::npos;
  });
}

/// Counts the bytes that a reader of the file could see after each flush.
class LiveSink : public base::StringSink {
 public:
  void flush() override { visible = bytes(); }
  std::string visible;
};

TEST(LockstepServer, FlushesGameLogWhenPlayModeChanges) {
  Match match(quick_match());
  LiveSink log;
  match.server->record(&log, nullptr);
  int turns = 0;
  std::size_t last = std::string::npos;

  while (!match.server->finished()) {
    match.run_cycle();
    const std::size_t turn = log.bytes().rfind("(playmode ");
    if (turn == last) continue;
    last = turn;
    ++turns;
    EXPECT_GT(log.visible.size(), turn);
  }

  EXPECT_THAT(log.visible, HasSubstr("(playmode 400 time_over)"));
  EXPECT_GE(turns, 4);
}

TEST(LockstepServer, PlaysMatchFromKickOffToTimeOver) {
  Match match(quick_match());
  match.run_to_end();
  const auto lines = referee_lines(match);
  ASSERT_GE(lines.size(), 8u);

  // The step after which the last player is connected is the first step of the wait.
  EXPECT_EQ(lines[0], "0,5\t(referee kick_off_l)");
  EXPECT_EQ(lines[1].substr(lines[1].find('\t')), "\t(referee play_on)");
  EXPECT_TRUE(contains(lines, "200,0\t(referee half_time)"));
  EXPECT_TRUE(contains(lines, "200,0\t(referee before_kick_off)"));
  EXPECT_TRUE(contains(lines, "200,4\t(referee kick_off_r)"));
  EXPECT_EQ(lines[lines.size() - 2], "400,0\t(referee time_up)");
  EXPECT_EQ(lines.back(), "400,0\t(referee time_over)");
  EXPECT_EQ(match.server->world().clock.time, 400);

  for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    EXPECT_EQ(match.server->missed_cycles(slot), 0);
  }
}

TEST(LockstepServer, RecordsEveryStepAndResult) {
  Match match(quick_match());
  match.run_to_end();
  const std::string& log = match.game_log.bytes();
  EXPECT_TRUE(log.starts_with("ULG6\n(server_param (audio_cut_dist 50)"));

  const auto frames = tests::read_frames(log);
  std::set<int> times;
  for (const auto& frame : frames) times.insert(frame.time);
  EXPECT_EQ(times.size(), 399u);
  EXPECT_EQ(times.count(200), 0u) << "half time has no frame";
  EXPECT_EQ(frames.back().mode, PlayMode::kTimeOver);

  const World& world = match.server->world();
  const std::string score = std::to_string(world.teams[0].score);
  const std::string other_score = std::to_string(world.teams[1].score);
  const auto lines = tests::split_lines(log);
  EXPECT_EQ(lines[lines.size() - 2], "(msg 400 1 \"(result 197001010000 Left_" + score +
                                         "-vs-Right_" + other_score + ")\")");
  EXPECT_EQ(lines.back(), "(team 400 Left Right " + score + " " + other_score + ")");
}

TEST(LockstepServer, ScoresGoals) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Match match(quick_match(seed));
    match.run_to_end();
    const World& world = match.server->world();
    if (world.teams[0].score + world.teams[1].score == 0) continue;
    EXPECT_TRUE(contains(referee_lines(match), "(referee goal_"));
    EXPECT_THAT(match.game_log.bytes(), HasSubstr(" goal_"));
    return;
  }
  FAIL() << "no goal in 30 matches";
}

TEST(LockstepServer, WritesSameBytesForSameSeed) {
  Match first(quick_match(7));
  Match second(quick_match(7));
  Match other(quick_match(8));
  first.run_to_end();
  second.run_to_end();
  other.run_to_end();
  EXPECT_TRUE(first.game_log.bytes() == second.game_log.bytes());
  EXPECT_TRUE(first.text_log.bytes() == second.text_log.bytes());
  EXPECT_FALSE(first.game_log.bytes() == other.game_log.bytes());
  EXPECT_FALSE(first.text_log.bytes() == other.text_log.bytes());
}

TEST(LockstepServer, DoesNotDependOnOrderOfSenders) {
  Match forward(quick_match());
  Match backward(quick_match());
  for (int cycle = 0; cycle < 150; ++cycle) {
    forward.run_cycle();
    backward.server->run_cycle();
    for (auto it = backward.clients.rbegin(); it != backward.clients.rend(); ++it) (*it)->act();
  }
  EXPECT_TRUE(forward.game_log.bytes() == backward.game_log.bytes());
  EXPECT_TRUE(forward.text_log.bytes() == backward.text_log.bytes());
}

TEST(LockstepServer, ExecutesBothTeamsFirstEquallyOften) {
  // The first player in the text log of a cycle was served first.
  Match match(quick_match());
  match.run_to_end();
  int left = 0;
  int cycles = 0;
  std::string_view stamp;

  for (const auto line : tests::split_lines(match.text_log.bytes())) {
    const std::string_view now = line.substr(0, line.find('\t'));
    if (now == stamp || line.find("\tRecv") == std::string_view::npos || now == "0,0") continue;
    stamp = now;
    ++cycles;
    left += line.find("Recv Left_") != std::string_view::npos;
  }

  ASSERT_GT(cycles, 400);
  EXPECT_NEAR(left, cycles / 2.0, 2 * std::sqrt(cycles)) << "four deviations";
}

TEST(LockstepServer, ContinuesIdenticallyFromForkedWorld) {
  Match match(quick_match());
  for (int cycle = 0; cycle < 120; ++cycle) match.run_cycle();
  World fork = match.server->world();
  const World before = fork;

  Events events;
  const auto go_on = [&events](World& world) {
    for (int i = 0; i < 50; ++i) {
      for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
        apply(world, slot, soccer::Dash{100, static_cast<double>(slot)}, events);
        apply(world, slot, soccer::Kick{50, 10}, events);
      }
      step(world, events);
      finish_step(world, events);
      events.clear();
    }

    gamelog::Frame frame;
    to_frame(world, frame);
    std::string text = std::to_string(frame.time);
    for (const auto& player : frame.players) {
      text += ' ' + std::to_string(player.position.x) + ' ' + std::to_string(player.body);
    }

    return text;
  };

  World again = before;
  const std::string result = go_on(fork);
  EXPECT_EQ(result, go_on(again));

  match.run_cycle();
  EXPECT_EQ(match.server->world().clock.time, before.clock.time + 1) << "the original is untouched";
}

TEST(LockstepServer, EndsAtCycleLimit) {
  MatchConfig config = quick_match();
  config.cycle_limit = 30;
  Match match(config);
  match.run_to_end();
  EXPECT_EQ(match.server->world().clock.time, 30);
  EXPECT_THAT(match.game_log.bytes(),
              HasSubstr("(msg 30 1 \"(result 197001010000 Left_0-vs-Right_0)\")"));
}

TEST(LockstepServer, CountsMissedCyclesAndContinues) {
  Match match(quick_match());
  for (int cycle = 0; cycle < 20; ++cycle) {
    match.server->run_cycle();
    for (auto& client : match.clients) {
      if (client->unum() != 3) client->act();
    }
  }
  EXPECT_EQ(match.server->missed_cycles(soccer::slot_of(Side::kLeft, 3)), 19);
  EXPECT_EQ(match.server->missed_cycles(soccer::slot_of(Side::kRight, 3)), 19);
  EXPECT_EQ(match.server->missed_cycles(soccer::slot_of(Side::kLeft, 4)), 0);
  EXPECT_GT(match.server->world().clock.time, 10);
}

TEST(LockstepServer, RemovesPlayerOfDisconnectedClient) {
  Match match(quick_match());
  for (int cycle = 0; cycle < 10; ++cycle) match.run_cycle();
  match.clients.erase(match.clients.begin() + 5);  // closes its channel
  match.clients[6]->send("(bye)");
  for (int cycle = 0; cycle < 3; ++cycle) match.run_cycle();
  const World& world = match.server->world();
  EXPECT_FALSE(world.player(Side::kLeft, 6).enabled);
  EXPECT_FALSE(world.player(Side::kLeft, 8).enabled);
  EXPECT_TRUE(world.player(Side::kLeft, 7).enabled);
  EXPECT_TRUE(contains({match.text_log.bytes()}, "Recv Left_8: (bye)\n"));
}

TEST(LockstepServer, SendsSensesInOrderOfRcssserver) {
  Match match(quick_match(), 2);
  match.first().keep_messages();
  match.clients[1]->send("(say \"hello\")");
  match.run_cycle();
  match.run_cycle();
  std::vector<std::string> kinds;
  for (const std::string& message : match.first().messages()) {
    kinds.push_back(message.substr(1, message.find_first_of(" )") - 1));
  }
  // The second hear message is the player's own say message of its first cycle.
  EXPECT_EQ(kinds, (std::vector<std::string>{"sense_body", "hear", "think", "sense_body", "hear",
                                             "see", "think"}));
}

TEST(LockstepServer, SendsSeeToOldClientsAtSendStep) {
  // One round every 37.5 ms, one see every fourth round: at 150, 300, 450, ... ms, which is twice
  // in three cycles, in the middle of a cycle or at its end.
  MatchConfig config = quick_match();
  config.server.kick_off_wait = 1000;
  Match match(config, 1, 15);
  match.first().keep_messages();
  std::vector<int> sees;
  for (int cycle = 0; cycle < 7; ++cycle) {
    match.run_cycle();
    sees.push_back(match.first().count("(see "));
  }
  EXPECT_EQ(sees, (std::vector<int>{1, 1, 2, 3, 3, 4, 5}));
}

}  // namespace
}  // namespace cls::simulator
