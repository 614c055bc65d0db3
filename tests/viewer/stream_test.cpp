// Matches written as chunks and read again, whole and in pieces.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/gamelog/recorded_match.h"
#include "tests/support/error_of.h"
#include "tests/support/files.h"
#include "tests/viewer/record_difference.h"
#include "viewer/stream/chunk.h"
#include "viewer/stream/chunk_reader.h"
#include "viewer/stream/chunk_writer.h"

namespace cls::viewer {
namespace {

using gamelog::MatchRecord;
using testing::HasSubstr;
using testing::Not;
using tests::record_difference;
using tests::record_of;

const char* const kLogs[] = {"rcg-v1-excerpt",
                             "rcg-v2-excerpt",
                             "rcg-v3-excerpt",
                             "rcg-v4-excerpt",
                             "rcg-v5-excerpt",
                             "rcg-v6-excerpt",
                             "rcg-json-excerpt",
                             "team-graphic-json-excerpt",
                             "team-graphic-v6-excerpt",
                             "match-start",
                             "recorded-messages-excerpt",
                             "../simulator/noise-free"};

MatchRecord parsed(std::string_view log) {
  base::MemorySource source(log);
  return gamelog::read_rcg(source);
}

std::string error_of(std::string_view stream) { return tests::error_of(read_stream(stream)); }

TEST(Stream, GivesRecordsOfAllVersionsBack) {
  for (const char* name : kLogs) {
    SCOPED_TRACE(name);
    const MatchRecord record = record_of(name);
    ASSERT_GT(record.frames(), 0U);
    const auto match = read_stream(write_stream(record, {}, "{}"));
    ASSERT_EQ(record_difference(record, match), "");
    EXPECT_EQ(match->statistics, "{}");
    EXPECT_FALSE(match->form.compact);
  }
}

TEST(Stream, HasTheHeightOfTheBallOnlyWhereTheLogHasIt) {
  const std::string flat = "ULG6\n(show 1 ((b) 1 2 0 0))\n(show 2 ((b) 1 2 0 0))\n";
  const std::string high = "ULG7\n(show 1 ((b) 1 2 0 0 0.25))\n(show 2 ((b) 1 2 0 0 1.75))\n";
  EXPECT_THAT(write_stream(parsed(flat), {}, ""), Not(HasSubstr("ball_z")));
  const std::string stream = write_stream(parsed(high), {}, "");
  EXPECT_THAT(stream, HasSubstr("ball_z"));
  const auto match = read_stream(stream);
  ASSERT_EQ(record_difference(parsed(high), match), "");
  EXPECT_EQ(match->record.ball_height[1], 1.75F);
}

TEST(Stream, GivesCorruptLogsBackWithTheirErrors) {
  const std::string log = tests::read_file(tests::fixture("gamelog/rcg-v6-excerpt.rcg.gz"));
  const MatchRecord record =
      parsed(log.substr(0, log.size() / 2) + "\n(show x)\n\xff\n(odd \xfe)\n");
  ASSERT_GT(record.errors.count, 1U);
  EXPECT_EQ(record_difference(record, read_stream(write_stream(record, {}, ""))), "");
}

TEST(Stream, StoresEveryValueOfSinglePrecision) {
  MatchRecord record = record_of("rcg-v6-excerpt");
  const float values[] = {-0.0F,  1e-30F,  3.4e38F,   -1e20F, 0.33333334F,
                          180.0F, -180.0F, 179.9996F, 540.0F};
  std::size_t next = 0;
  for (std::size_t i = 0; i < record.players.body.size(); i += 7) {
    const float value = values[next++ % std::size(values)];
    record.players.body[i] = value;
    record.players.position[i].x = value;
    record.players.velocity[i].y = value;
    record.players.stamina[i] = value;
    record.players.pointing_at[i].x = value;
  }

  EXPECT_EQ(record_difference(record, read_stream(write_stream(record, {}, ""))), "");
}

TEST(Stream, IsTheSameMatchInPiecesOfAnySize) {
  const MatchRecord record = record_of("match-start");
  for (const std::size_t piece : {1U, 7U, 50U}) {
    SCOPED_TRACE(piece);
    ChunkWriter writer({.live = true});
    ChunkReader reader;
    std::string out;
    writer.append_header(record, out);
    for (std::size_t end = piece; writer.frames() < record.frames(); end += piece) {
      writer.append_frames(record, std::min(end, record.frames()), out);
      ASSERT_TRUE(reader.add(out));
      ASSERT_EQ(reader.match().record.frames(), writer.frames());
      out.clear();
    }

    EXPECT_FALSE(reader.match().ended);

    writer.append_end(record, out);
    ASSERT_TRUE(reader.add(out));
    EXPECT_TRUE(reader.match().ended);
    EXPECT_EQ(record_difference(record, reader.match().record), "");
  }
}

TEST(Stream, ArrivesByteByByte) {
  MatchRecord record = record_of("rcg-v5-excerpt");
  gamelog::resize_frames(record, std::min<std::size_t>(record.frames(), 20));
  std::erase_if(record.notes, [&](const auto& note) { return note.frame > record.frames(); });
  const std::string stream = write_stream(record, {}, "");
  ChunkReader reader;
  for (const char byte : stream) ASSERT_TRUE(reader.add({&byte, 1}));
  EXPECT_TRUE(reader.match().ended);
  EXPECT_EQ(reader.match().record.frames(), record.frames());
}

std::string column_of(const std::string& stream, const std::string& name) {
  const std::size_t start = stream.find("{\"name\":\"" + name + "\"");
  return stream.substr(start, stream.find('}', start) - start);
}

TEST(Stream, FitsColumnsToTheirValues) {
  MatchRecord record = record_of("match-start");
  std::string stream = write_stream(record, {}, "");
  EXPECT_THAT(column_of(stream, "neck"), HasSubstr("\"scale\":1"));
  EXPECT_THAT(column_of(stream, "neck"), Not(HasSubstr("\"scale\":10")));
  EXPECT_THAT(column_of(stream, "focus_distance"), HasSubstr("\"c\""));

  for (std::size_t i = 0; i < record.players.focus.size(); ++i) {
    record.players.focus[i].x = 0.001F * static_cast<float>(i % 1000);
  }
  record.players.neck[5] = 12.5F;
  record.players.neck[6] = -0.0F;
  record.players.neck[7] = 1.0F / 3.0F;  // in no scale
  stream = write_stream(record, {}, "");

  EXPECT_THAT(column_of(stream, "focus_distance"),
              HasSubstr("\"d1\",\"series\":22,\"scale\":1000"));
  EXPECT_THAT(column_of(stream, "neck"), HasSubstr("\"scale\":10"));
  EXPECT_THAT(column_of(stream, "neck"), Not(HasSubstr("\"scale\":100")));
  EXPECT_EQ(record_difference(record, read_stream(stream)), "");
  // A live match may have any values later.
  EXPECT_THAT(column_of(write_stream(record, {.live = true}, ""), "neck"),
              HasSubstr("\"scale\":1000"));
}

TEST(Stream, RoundsInCompactForm) {
  const MatchRecord record = record_of("match-start");
  const std::string compact = write_stream(record, {.compact = true}, "");
  EXPECT_LT(compact.size(), 130'000U);  // the exact form: 167'000
  const auto match = read_stream(compact);
  ASSERT_TRUE(match) << match.error().message;
  EXPECT_TRUE(match->form.compact);
  ASSERT_EQ(match->record.frames(), record.frames());
  for (std::size_t i = 0; i < record.players.position.size(); ++i) {
    ASSERT_NEAR(match->record.players.position[i].x, record.players.position[i].x, 0.0051);
    ASSERT_NEAR(match->record.players.stamina[i], record.players.stamina[i], 0.51);
    ASSERT_EQ(match->record.players.state[i], record.players.state[i]);
  }
}

TEST(Stream, SkipsUnknownChunks) {
  const MatchRecord record = record_of("rcg-v6-excerpt");
  ChunkWriter writer({});
  std::string out;
  writer.append_header(record, out);
  ChunkReader reader;

  ASSERT_TRUE(reader.add(out));

  std::string unknown;
  append_chunk(static_cast<ChunkKind>('Z'), "of a later version", unknown);
  EXPECT_TRUE(reader.add(unknown));

  out.clear();
  writer.append_frames(record, record.frames(), out);
  EXPECT_TRUE(reader.add(out));
  EXPECT_EQ(reader.match().record.frames(), record.frames());
}

TEST(Stream, SaysWhatIsWrong) {
  const MatchRecord record = record_of("rcg-v6-excerpt");
  const std::string stream = write_stream(record, {}, "");
  EXPECT_EQ(error_of(""), "truncated: the match has no end");
  EXPECT_EQ(error_of(stream.substr(0, stream.size() / 2)), "truncated: the match has no end");
  EXPECT_EQ(error_of("F\x01x"), "no header: not a match of cls");
  EXPECT_EQ(error_of(stream + stream), "a chunk after the end");

  std::string later = stream;
  later.replace(later.find("cls.view/1"), 10, "cls.view/2");
  EXPECT_EQ(error_of(later),
            "schema cls.view/2 is newer than this cls reads (cls.view/1); update cls");

  std::string changed = stream;
  changed[changed.find("offside_active_area_size") + 3] ^= 1;
  EXPECT_EQ(error_of(changed), "wrong checksum: the match is corrupt");
}

TEST(Stream, SurvivesAnyChangedByte) {
  MatchRecord record = record_of("rcg-v6-excerpt");
  gamelog::resize_frames(record, 3);
  record.notes.clear();
  record.parameter_lines.clear();
  std::string header;
  ChunkWriter writer({});
  writer.append_header(record, header);
  std::string frames;
  writer.append_frames(record, record.frames(), frames);
  writer.append_end(record, frames);
  for (std::size_t i = 0; i < frames.size(); i += 11) {
    std::string changed = frames;
    changed[i] ^= static_cast<char>(0x81);
    EXPECT_NE(error_of(header + changed), "") << "byte " << i;
  }
}

}  // namespace
}  // namespace cls::viewer
