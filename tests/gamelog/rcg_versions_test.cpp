// Rcssserver logs of every version, replayed into the writer of running matches.
#include <gtest/gtest.h>

#include <algorithm>
#include <variant>

#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcg/rcg_writer.h"
#include "gamelog/rcg/record_writer.h"
#include "tests/support/files.h"

namespace cls::gamelog {
namespace {

MatchRecord read(std::string_view log) {
  base::MemorySource source(log);
  return read_rcg(source);
}

constexpr std::string_view kResult = "(result ";

std::string date_of_result(const MatchRecord& record) {
  for (const Note& note : record.notes) {
    const auto* message = std::get_if<Message>(&note.content);
    if (message != nullptr && message->text.starts_with(kResult)) {
      return message->text.substr(kResult.size(), 12);
    }
  }
  return {};
}

/// Writes the parameters, frames and messages of a log.
std::string played_back(const MatchRecord& record) {
  base::StringSink sink;
  LogDate date{date_of_result(record), record.timestamp};
  RcgWriter writer(sink, record.version, date);
  writer.write_header(record.server, record.player, record.types);
  std::size_t next = 0;
  const auto notes_until = [&](std::size_t frame) {
    for (; next < record.notes.size() && record.notes[next].frame <= frame; ++next) {
      const Note& note = record.notes[next];
      const auto* message = std::get_if<Message>(&note.content);
      if (message == nullptr || message->text.starts_with(kResult)) continue;
      writer.write_message({note.time, note.stopped}, message->board, message->text);
    }
  };

  for (std::size_t i = 0; i < record.frames(); ++i) {
    notes_until(i);
    writer.write_step(frame_at(record, i));
  }

  notes_until(record.frames());
  Frame last = frame_at(record, record.frames() - 1);
  last.stopped = record.notes.back().stopped;  // it continues after the last frame
  writer.write_end(last);
  return sink.bytes();
}

std::string fixture(const std::string& name) {
  return tests::read_file(tests::fixture("gamelog/" + name + ".rcg.gz"));
}

void expect_same(const std::string& expected, const std::string& actual) {
  EXPECT_EQ(expected.size(), actual.size());
  const auto difference =
      std::mismatch(expected.begin(), expected.end(), actual.begin(), actual.end());
  if (difference.first == expected.end() && difference.second == actual.end()) return;
  const auto at = static_cast<std::size_t>(difference.first - expected.begin());
  const std::size_t from = at < 60 ? 0 : at - 60;
  ADD_FAILURE() << "expected " << expected.substr(from, 120) << "\ngot      "
                << actual.substr(from, 120);
}

/// Removes the folder, which logs of cls do not contain.
std::string without_folders(std::string log) {
  for (const std::string name : {"game_log_dir", "text_log_dir"}) {
    const std::size_t at = log.find(name);
    EXPECT_NE(at, std::string::npos);
    // (game_log_dir "./") and "game_log_dir":"./"
    const std::size_t value = log.find('"', at + name.size() + 1) + 1;
    log.replace(value, log.find('"', value) - value, "./");
  }
  return log;
}

TEST(RcgVersions, ReproducesTextAndJsonByteForByte) {
  for (const char* name : {"rcg-v4-excerpt", "rcg-v6-excerpt", "rcg-json-excerpt"}) {
    SCOPED_TRACE(name);
    const std::string log = fixture(name);
    expect_same(without_folders(log), played_back(read(log)));
  }
}

// Unused bytes are uninitialized memory of rcssserver, so only parsed records are compared.
TEST(RcgVersions, ReproducesRecordsOfBinaryLogs) {
  for (const char* name : {"rcg-v1-excerpt", "rcg-v2-excerpt", "rcg-v3-excerpt"}) {
    SCOPED_TRACE(name);
    const std::string log = fixture(name);
    const MatchRecord record = read(log);
    const std::string written = played_back(record);
    const MatchRecord again = read(written);
    EXPECT_TRUE(again.errors.empty());
    EXPECT_EQ(again.version, record.version);
    base::StringSink expected;
    base::StringSink actual;
    write_rcg(record, RcgVersion::kV6, expected);
    write_rcg(again, RcgVersion::kV6, actual);
    expect_same(expected.bytes(), actual.bytes());
    EXPECT_EQ(written.size(), log.size());
  }
}

TEST(RcgVersions, AcceptsOnlyVersionsOfRcssserver) {
  for (int version = 1; version <= 6; ++version) {
    EXPECT_EQ(rcg_version(version), static_cast<RcgVersion>(version));
  }
  EXPECT_EQ(rcg_version(-1), RcgVersion::kJson);
  for (const int none : {-2, 0, 7}) EXPECT_FALSE(rcg_version(none));
}

}  // namespace
}  // namespace cls::gamelog
