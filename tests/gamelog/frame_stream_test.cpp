// A stream passes on what read_rcg() reads, and keeps little of it.
#include "gamelog/rcg/frame_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "gamelog/rcg/rcg_reader.h"
#include "tests/support/files.h"

namespace cls::gamelog {
namespace {

using tests::fixture;

// Time, stopped, mode, left score, ball and the last player.
using Seen = std::tuple<int, int, soccer::PlayMode, int, float, float, std::uint32_t, float>;

Seen seen_at(const MatchRecord& record, std::size_t frame) {
  const std::size_t last = frame * kSlots + kSlots - 1;
  return {record.time[frame],
          record.stopped[frame],
          record.mode[frame],
          record.teams[record.team_state[frame]][0].score,
          record.ball_position[frame].x,
          record.ball_velocity[frame].y,
          record.players.state[last],
          record.players.stamina[last]};
}

class Recorder : public FrameListener {
 public:
  void on_frame(const MatchRecord& record, std::size_t frame) override {
    seen.push_back(seen_at(record, frame));
    most = std::max(most, record.frames());
  }

  std::vector<Seen> seen;
  std::size_t most = 0;
};

class LogStream : public testing::TestWithParam<const char*> {};

TEST_P(LogStream, PassesOnTheFramesOfTheRecord) {
  const std::string bytes = tests::read_file(fixture(std::string("gamelog/") + GetParam()));
  base::MemorySource whole(bytes);
  const MatchRecord record = read_rcg(whole);
  std::vector<Seen> expected;
  for (std::size_t i = 0; i < record.frames(); ++i) expected.push_back(seen_at(record, i));
  ASSERT_FALSE(expected.empty());

  base::MemorySource source(bytes);
  Recorder recorder;
  FrameStream stream(source, recorder);
  const MatchRecord& rest = stream.read_all();

  EXPECT_EQ(recorder.seen, expected);
  EXPECT_EQ(stream.frames(), expected.size());
  EXPECT_EQ(rest.frames(), 0u);
  EXPECT_EQ(rest.errors.count, record.errors.count);
  EXPECT_EQ(rest.parameter_lines, record.parameter_lines);
  EXPECT_EQ(rest.final_teams(), record.final_teams());
}

INSTANTIATE_TEST_SUITE_P(Versions, LogStream,
                         testing::Values("rcg-v1-excerpt.rcg.gz", "rcg-v2-excerpt.rcg.gz",
                                         "rcg-v3-excerpt.rcg.gz", "rcg-v4-excerpt.rcg.gz",
                                         "rcg-v5-excerpt.rcg.gz", "rcg-v6-excerpt.rcg.gz",
                                         "rcg-json-excerpt.rcg.gz", "match-start.rcg.gz"));

TEST(FrameStream, KeepsFewFramesOfALongLog) {
  const std::string bytes = tests::read_file(fixture("gamelog/match-start.rcg.gz"));
  const std::size_t first_show = bytes.find("(show ");
  std::string log = bytes;
  for (int i = 0; i < 4; ++i) log += bytes.substr(first_show);
  base::MemorySource source(log);
  Recorder recorder;
  FrameStream stream(source, recorder);
  stream.read_all();

  EXPECT_GT(recorder.seen.size(), 1000u);
  EXPECT_LT(recorder.most, 200u);
}

TEST(FrameStream, LooksAtTheStartBeforeItReads) {
  const std::string bytes = tests::read_file(fixture("gamelog/rcg-v6-excerpt.rcg.gz"));
  base::MemorySource source(bytes);
  Recorder recorder;
  FrameStream stream(source, recorder);
  EXPECT_EQ(stream.input().peek(4), "ULG6");
  EXPECT_TRUE(stream.read_all().errors.empty());
  EXPECT_FALSE(recorder.seen.empty());
}

TEST(FrameStream, ReportsATruncatedSource) {
  const std::string bytes = tests::read_file(fixture("gamelog/rcg-v6-excerpt.rcg.gz"));
  base::MemorySource source(std::string_view(bytes).substr(0, bytes.size() / 2));
  Recorder recorder;
  FrameStream stream(source, recorder);
  const MatchRecord& rest = stream.read_all();
  ASSERT_EQ(rest.errors.count, 1u);
  EXPECT_EQ(rest.errors.first[0].message, "truncated log");
  EXPECT_FALSE(recorder.seen.empty());
}

}  // namespace
}  // namespace cls::gamelog
