// Rcssserver logs read and written again, in their own version and in others.
#include "gamelog/rcg/record_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/io/gzip_sink.h"
#include "gamelog/rcg/rcg_reader.h"
#include "tests/support/files.h"
#include "tests/support/rcg_lines.h"
#include "tests/support/temporary_folder.h"

namespace cls::gamelog {
namespace {

using testing::HasSubstr;

MatchRecord read(std::string_view log) {
  base::MemorySource source(log);
  return read_rcg(source);
}

std::string written(const MatchRecord& record, RcgVersion version) {
  base::StringSink sink;
  write_rcg(record, version, sink);
  return sink.bytes();
}

std::string fixture(const std::string& name) {
  return tests::read_file(tests::fixture("gamelog/" + name + ".rcg.gz"));
}

/// Reports only the first line that differs, because the logs have tens of megabytes.
void expect_same(std::string_view expected, std::string_view actual) {
  if (expected == actual) return;
  const auto expected_lines = tests::split_lines(expected);
  const auto actual_lines = tests::split_lines(actual);
  for (std::size_t i = 0; i < std::min(expected_lines.size(), actual_lines.size()); ++i) {
    ASSERT_EQ(expected_lines[i], actual_lines[i]) << "line " << i + 1;
  }
  FAIL() << expected_lines.size() << " lines expected, " << actual_lines.size() << " written";
}

TEST(WriteRcg, ReproducesRcssserverLogsByteForByte) {
  for (const char* name : {"rcg-v4-excerpt", "rcg-v5-excerpt", "rcg-v6-excerpt",
                           "recorded-messages-excerpt", "team-graphic-v6-excerpt", "match-start",
                           "rcg-json-excerpt", "team-graphic-json-excerpt"}) {
    SCOPED_TRACE(name);
    const std::string log = fixture(name);
    const MatchRecord record = read(log);
    expect_same(log, written(record, record.version));
  }
}

TEST(WriteRcg, ReproducesWholeRcssserverLogsByteForByte) {
  for (const char* name :
       {"logs/rcg-v4", "logs/rcg-v5", "logs/rcg-v6", "logs/rcg-json", "logs/team-graphic-v6",
        "logs/team-graphic-json", "logs/recorded-messages", "logs/extra-time-and-penalties",
        "logs/helios-vs-helios-full", "logs/cyrus-vs-helios-full"}) {
    const auto path = tests::data(std::string(name) + ".rcg.gz");
    if (!path) GTEST_SKIP() << "no data: set CLS_DATA";
    SCOPED_TRACE(name);
    const std::string log = tests::read_file(*path);
    const MatchRecord record = read(log);
    EXPECT_TRUE(record.errors.empty());
    expect_same(log, written(record, record.version));
  }
}

TEST(WriteRcg, RoundTripsTextThroughJson) {
  for (const char* name : {"rcg-v6-excerpt", "match-start", "team-graphic-v6-excerpt"}) {
    SCOPED_TRACE(name);
    const std::string log = fixture(name);
    const std::string json = written(read(log), RcgVersion::kJson);
    const MatchRecord again = read(json);
    EXPECT_EQ(again.version, RcgVersion::kJson);
    expect_same(log, written(again, RcgVersion::kV6));
  }
}

TEST(WriteRcg, RoundTripsJsonThroughTextExceptDate) {
  const std::string log = fixture("rcg-json-excerpt");
  const std::string back = written(read(written(read(log), RcgVersion::kV6)), RcgVersion::kJson);
  const auto expected = tests::split_lines(log);
  const auto actual = tests::split_lines(back);
  ASSERT_EQ(actual.size() + 2, expected.size());  // version and timestamp
  int different = 0;
  for (std::size_t i = 1; i < actual.size(); ++i) different += actual[i] != expected[i + 2];
  EXPECT_EQ(different, 2);  // the stopped clock of the last message and team, after the last show
}

std::string first_player(const std::string& log) {
  const std::size_t at = log.find("((l 2)", log.find("(show 2 "));
  return log.substr(at, log.find("((l 3)", at) - at);
}

TEST(WriteRcg, OmitsDataUnknownToVersion) {
  const MatchRecord record = read(fixture("rcg-v6-excerpt"));

  EXPECT_EQ(first_player(written(record, RcgVersion::kV6)),
            "((l 2) 11 0x1 -24.4213 -4.8806 0.2302 0.0475 13.549 -90 (v h 180) (fp 0 0) (s 7940.75 "
            "0.870176 1 130559) (c 0 1 116 0 1 118 1 1 0 0 2 0)) ");
  EXPECT_EQ(first_player(written(record, RcgVersion::kV5)),
            "((l 2) 11 0x1 -24.4213 -4.8806 0.2302 0.0475 13.549 -90 (v h 180) (s 7940.75 0.870176 "
            "1 130559) (c 0 1 116 0 1 118 1 1 0 0 2)) ");
  EXPECT_EQ(first_player(written(record, RcgVersion::kV4)),
            "((l 2) 11 0x1 -24.4213 -4.8806 0.2302 0.0475 13.549 -90 (v h 180) (s 7940.75 0.870176 "
            "1) (c 0 1 116 0 1 118 1 1 0 0 2)) ");

  for (const RcgVersion version : {RcgVersion::kV4, RcgVersion::kV5}) {
    const MatchRecord again = read(written(record, version));
    EXPECT_EQ(again.version, version);
    EXPECT_TRUE(again.errors.empty());
    EXPECT_EQ(again.frames(), record.frames());
  }
}

// The excerpt as the 2.5D server would write it: version 7, and a ball that rises.
std::string version_7_excerpt() {
  std::string log;
  int height = 0;
  const std::string flat = fixture("rcg-v6-excerpt");

  for (const std::string_view line : tests::split_lines(flat)) {
    std::string changed(line == "ULG6" ? "ULG7" : line);
    const std::size_t ball = changed.find("((b)");
    if (changed.starts_with("(show ") && ball != std::string::npos) {
      changed.insert(changed.find(')', ball + 4), " " + std::to_string(++height) + ".5");
    }
    log += changed + "\n";
  }

  return log;
}

TEST(WriteRcg, KeepsTheHeightOfVersion7) {
  const std::string log = version_7_excerpt();
  const MatchRecord record = read(log);
  ASSERT_TRUE(record.errors.empty());
  expect_same(log, written(record, RcgVersion::kV7));

  const std::string json = written(record, RcgVersion::kJson);
  EXPECT_THAT(json, HasSubstr("\"z\":1.5}"));
  const MatchRecord from_json = read(json);
  EXPECT_TRUE(from_json.has_ball_height);
  expect_same(log, written(from_json, RcgVersion::kV7));
  expect_same(fixture("rcg-v6-excerpt"), written(record, RcgVersion::kV6));
}

TEST(WriteRcg, WritesSwitchesThatAreWordsAsJson) {
  MatchRecord record;
  record.parameter_lines = {"(server_param (auto_mode true)(use_offside false)(back_passes 0))"};
  EXPECT_THAT(written(record, RcgVersion::kJson),
              HasSubstr("\"auto_mode\":true,\"use_offside\":false,\"back_passes\":false"));
}

TEST(WriteRcg, ConvertsBinaryLogsToText) {
  for (const char* name : {"rcg-v1-excerpt", "rcg-v2-excerpt", "rcg-v3-excerpt"}) {
    SCOPED_TRACE(name);
    const MatchRecord record = read(fixture(name));
    const MatchRecord again = read(written(record, RcgVersion::kV6));
    EXPECT_TRUE(again.errors.empty());
    ASSERT_EQ(again.frames(), record.frames());
    EXPECT_EQ(again.final_teams(), record.final_teams());
    EXPECT_EQ(again.server.half_time, record.server.half_time);
    EXPECT_EQ(again.types.size(), record.types.size());

    for (std::size_t i = 0; i < record.frames(); ++i) {
      ASSERT_EQ(again.mode[i], record.mode[i]);
      ASSERT_EQ(again.stopped[i], record.stopped[i]);
      const std::size_t entry = i * kSlots + 20;
      ASSERT_NEAR(again.players.position[entry].x, record.players.position[entry].x, 6e-5);
      ASSERT_NEAR(again.players.body[entry], record.players.body[entry], 6e-4);
      ASSERT_EQ(again.players.counters[entry], record.players.counters[entry]);
    }
  }
}

TEST(WriteRcg, EscapesStringsInJson) {
  MatchRecord record;
  record.notes.push_back({0, 5, 3, Message{2, "a\"b\\c\n\x01\xc3\xbc"}});
  EXPECT_THAT(
      written(record, RcgVersion::kJson),
      HasSubstr("{\"msg\":{\"time\":5,\"stime\":3,\"board\":2,\"message\":\"a\\\"b\\\\c\\u000a"
                "\\u0001\xc3\xbc\"}}\n]\n"));
}

TEST(GzipSink, RoundTripsCompressedData) {
  const tests::TemporaryFolder folder;
  const std::string log = fixture("match-start");
  const MatchRecord record = read(log);

  for (const char* name : {"a.rcg.gz", "b.rcg.gz", "c.rcg"}) {
    auto sink = base::create_sink((folder.path() / name).string());
    ASSERT_TRUE(sink);
    write_rcg(record, RcgVersion::kV6, **sink);
    ASSERT_TRUE((*sink)->close());
    EXPECT_EQ(tests::read_file(folder.path() / name), log);
  }
  EXPECT_LT(file_size(folder.path() / "a.rcg.gz") * 3, file_size(folder.path() / "c.rcg"));
}

TEST(GzipSink, ReportsWriteErrors) {
  EXPECT_EQ(base::create_sink("/nonexistent-folder/a.rcg.gz").error().message,
            "cannot create '/nonexistent-folder/a.rcg.gz': No such file or directory");
}

}  // namespace
}  // namespace cls::gamelog
