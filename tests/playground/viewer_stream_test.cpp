// The stream of the viewer has the match of the game log, however its bytes come.
#include "playground/viewer_stream.h"

#include <gtest/gtest.h>

#include <string>

#include "base/io/byte_source.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcg/rcg_writer.h"
#include "gamelog/rcg/record_writer.h"
#include "playground/match.h"
#include "viewer/stream/chunk_reader.h"

namespace cls::playground {
namespace {

// The game log of a match, and what its view gave in pieces of `steps` steps.
struct Played {
  std::string log;
  std::string view;
  int pieces = 0;
};

Played play(int steps) {
  MatchSetup setup;
  setup.sides = {"mock:simple", "mock:simple"};
  setup.seed = 3;
  setup.cycles = 90;
  setup.view = true;
  auto match = Match::create(setup);
  if (!match) return {};

  Played played;
  bool plays = true;
  while (plays) {
    plays = (*match)->play(steps);
    played.log += (*match)->take_game_log();
    played.view += (*match)->take_view();
    ++played.pieces;
  }
  EXPECT_EQ((*match)->take_view(), "") << "after the end";
  return played;
}

std::string text_of(const gamelog::MatchRecord& record) {
  base::StringSink sink;
  gamelog::write_rcg(record, gamelog::RcgVersion::kV6, sink);
  return sink.bytes();
}

TEST(PlaygroundView, HasEveryFrameAndNoteOfTheLog) {
  const Played played = play(10);
  ASSERT_GT(played.pieces, 5);
  const auto stream = viewer::read_stream(played.view);
  ASSERT_TRUE(stream) << stream.error().message;
  base::MemorySource source(played.log);
  const gamelog::MatchRecord record = gamelog::read_rcg(source);

  EXPECT_GT(record.frames(), 90U);
  EXPECT_EQ(stream->record.frames(), record.frames());
  EXPECT_TRUE(stream->record.errors.empty());
  EXPECT_TRUE(text_of(stream->record) == text_of(record));
  EXPECT_TRUE(stream->ended);
}

TEST(PlaygroundView, DoesNotDependOnThePieces) {
  const auto whole = viewer::read_stream(play(100'000).view);
  const auto pieces = viewer::read_stream(play(1).view);
  ASSERT_TRUE(whole && pieces);
  EXPECT_TRUE(text_of(whole->record) == text_of(pieces->record));
}

TEST(PlaygroundView, WaitsForTheEndOfALine) {
  const Played played = play(100'000);
  ViewerStream stream;
  std::string chunks;
  for (std::size_t at = 0; at < played.log.size(); at += 10'007) {
    stream.write(std::string_view(played.log).substr(at, 10'007));
    chunks += stream.take(false);
  }
  chunks += stream.take(true);

  const auto read = viewer::read_stream(chunks);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_TRUE(read->record.errors.empty());
  EXPECT_TRUE(text_of(read->record) == text_of(viewer::read_stream(played.view)->record));
}

}  // namespace
}  // namespace cls::playground
