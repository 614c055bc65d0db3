// Mocks play soccer: goals on both sides, set plays, movement over the whole pitch.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "gamelog/rcg/rcg_reader.h"
#include "soccer/pitch.h"
#include "soccer/play_mode.h"
#include "tests/matches/full_tests.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using gamelog::MatchRecord;
using soccer::PlayMode;

/// Sums over all matches of a test.
struct Play {
  int left_goals = 0;
  int right_goals = 0;
  int set_plays = 0;  ///< of any kind, kick-offs included
  int kick_ins = 0;
  int offsides = 0;
  long frames = 0;
  long ball_in_right_half = 0;
  std::array<long, 2> team_in_opponents_half{};
  double farthest_x = 0.0;
  double farthest_y = 0.0;
};

void add_frame(const MatchRecord& record, std::size_t frame, Play& play) {
  ++play.frames;
  if (record.ball_position[frame].x > 0) ++play.ball_in_right_half;
  std::array<double, 2> x_sum{};
  for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    const auto point =
        record.players.position[frame * soccer::kPlayersOnPitch + static_cast<std::size_t>(slot)];
    play.farthest_x = std::max(play.farthest_x, static_cast<double>(std::fabs(point.x)));
    play.farthest_y = std::max(play.farthest_y, static_cast<double>(std::fabs(point.y)));
    x_sum[slot < soccer::kPlayersPerTeam ? 0 : 1] += point.x;
  }
  if (x_sum[0] > 0) ++play.team_in_opponents_half[0];
  if (x_sum[1] < 0) ++play.team_in_opponents_half[1];
}

void add_modes(const MatchRecord& record, Play& play) {
  for (std::size_t frame = 1; frame < record.mode.size(); ++frame) {
    const PlayMode mode = record.mode[frame];
    if (mode == record.mode[frame - 1]) continue;
    if (is_set_play(mode)) ++play.set_plays;
    if (mode == PlayMode::kKickInLeft || mode == PlayMode::kKickInRight) ++play.kick_ins;
    if (mode == PlayMode::kOffsideLeft || mode == PlayMode::kOffsideRight) ++play.offsides;
  }
}

void play_one(int seed, int cycles, Play& play) {
  TemporaryFolder folder;
  Command match({cls_binary(), "match", "mock", "mock", "--seed", std::to_string(seed), "--cycles",
                 std::to_string(cycles), "--set", "server::kick_off_wait=3", "--dir",
                 folder.path()});
  const CommandResult ended = match.finish(std::chrono::seconds(300));
  ASSERT_EQ(ended.exit_code, 0) << ended.err;

  const auto result = base::Json::parse(read_file(folder.path() / "result.json"));
  ASSERT_EQ(result["cycles"], cycles);

  for (const char* side : {"left", "right"}) {
    for (const auto& player : result[side]["players"]) {
      ASSERT_TRUE(player["unimplemented_actions"].empty()) << player;
      ASSERT_EQ(player["missed"], 0) << player;
    }
  }
  play.left_goals += result["left"]["score"].get<int>();
  play.right_goals += result["right"]["score"].get<int>();

  const auto record = gamelog::read_rcg_file(folder.path() / "match.rcg");
  ASSERT_TRUE(record) << record.error().message;
  ASSERT_EQ(record->time.back(), cycles);

  add_modes(*record, play);
  for (std::size_t frame = 0; frame < record->mode.size(); ++frame) {
    if (record->mode[frame] == PlayMode::kPlayOn) add_frame(*record, frame, play);
  }
}

TEST(Play, LooksLikeSoccer) {
  const int matches = full_tests_requested() ? 20 : 3;
  const int cycles = full_tests_requested() ? 6000 : 1500;
  Play play;

  for (int seed = 1; seed <= matches; ++seed) {
    ASSERT_NO_FATAL_FAILURE(play_one(seed, cycles, play)) << "seed " << seed;
  }
  const auto share = [&](long count) {
    return static_cast<double>(count) / static_cast<double>(play.frames);
  };
  std::cout << matches << " matches of " << cycles << " cycles: goals " << play.left_goals << ":"
            << play.right_goals << ", set plays " << play.set_plays << ", kick-ins "
            << play.kick_ins << ", offsides " << play.offsides << ", ball in the right half "
            << share(play.ball_in_right_half) << ", teams in the opponents' half "
            << share(play.team_in_opponents_half[0]) << " and "
            << share(play.team_in_opponents_half[1]) << "\n";

  EXPECT_GT(play.set_plays, 3 * matches);

  if (full_tests_requested()) {  // rare enough to be missing from a few short matches
    EXPECT_GT(play.left_goals, matches / 2);
    EXPECT_GT(play.right_goals, matches / 2);
    EXPECT_GT(play.kick_ins, matches);
    EXPECT_GT(play.offsides, matches);
  }
  // No player beyond the margin of the pitch.
  EXPECT_LE(play.farthest_x, soccer::kOuterHalfLength + 1e-3);
  EXPECT_LE(play.farthest_y, soccer::kOuterHalfWidth + 1e-3);
  // The ball reaches both halves, and both teams move up as a whole.
  EXPECT_GT(share(play.ball_in_right_half), 0.2);
  EXPECT_LT(share(play.ball_in_right_half), 0.8);
  EXPECT_GT(share(play.team_in_opponents_half[0]), 0.1);
  EXPECT_GT(share(play.team_in_opponents_half[1]), 0.1);
}

TEST(Play, FullMatchIsReproducible) {
  if (!full_tests_requested())
    GTEST_SKIP() << "whole matches: make full (cli.Determinism has shorter ones)";
  TemporaryFolder folder;
  for (const char* name : {"a", "b"}) {
    Command match(
        {cls_binary(), "match", "mock", "mock", "--seed", "7", "--dir", folder.path() / name});
    ASSERT_EQ(match.finish(std::chrono::seconds(300)).exit_code, 0);
  }
  for (const char* file : {"match.rcg", "match.rcl", "events.jsonl"}) {
    EXPECT_TRUE(read_file(folder.path() / "a" / file) == read_file(folder.path() / "b" / file))
        << file;
  }
}

}  // namespace
}  // namespace cls::tests
