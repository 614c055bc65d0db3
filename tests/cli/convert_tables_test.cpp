// End-to-end tests of `cls convert` into tables.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;
using json = base::Json;
using testing::HasSubstr;
using testing::StartsWith;

class ConvertTables : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  CommandResult convert(const std::vector<std::string>& arguments) const {
    return Command(joined({cls_binary().string(), "convert"}, arguments), {}, folder_.path())
        .finish();
  }

  static std::string log(const std::string& name) { return fixture("gamelog/" + name).string(); }

  void put_log(const std::string& fixture_name, const std::string& name) const {
    fs::create_directories(fs::path(path(name)).parent_path());
    fs::copy_file(log(fixture_name), path(name));
  }

  TemporaryFolder folder_;
};

TEST_F(ConvertTables, NameOfOutDecides) {
  const std::string game = log("rcg-v6-excerpt.rcg.gz");
  for (const std::string table : {"tracking", "player_types", "event"}) {
    SCOPED_TRACE(table);
    EXPECT_EQ(convert({game, "a." + table + ".csv"}).exit_code, 0);
    EXPECT_EQ(convert({game, "a." + table + ".csv.gz"}).exit_code, 0);
    const CommandResult printed = convert({game, "-", "--to", table});
    EXPECT_EQ(printed.exit_code, 0) << printed.err;
    EXPECT_EQ(read_file(path("a." + table + ".csv")), printed.out);
    EXPECT_EQ(read_file(path("a." + table + ".csv.gz")), printed.out);
    EXPECT_NE(printed.out, "");
  }
  EXPECT_LT(fs::file_size(path("a.tracking.csv.gz")), fs::file_size(path("a.tracking.csv")) / 2);
}

TEST_F(ConvertTables, AllTablesOfAFolderKeepItsFolders) {
  put_log("rcg-v6-excerpt.rcg.gz", "cup/matches/1/match.rcg.gz");
  put_log("rcg-v4-excerpt.rcg.gz", "cup/matches/2/match.rcg.gz");
  const CommandResult result = convert({"cup", "--tables", "csv", "--jobs", "2", "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const json document = json::parse(result.out);
  EXPECT_EQ(document["schema"], "cls.convert/1");
  EXPECT_EQ(document["tables"], "csv");
  EXPECT_EQ(document["matches"], 2);
  EXPECT_EQ(document["frames"], 25 + 32);

  for (const std::string number : {"1", "2"}) {
    const std::string game = "cup/matches/" + number + "/match.rcg.gz";
    for (const std::string table : {"tracking", "player_types", "event"}) {
      EXPECT_EQ(read_file(path("csv/matches/" + number + "/match." + table + ".csv")),
                convert({game, "-", "--to", table}).out);
    }
  }

  EXPECT_THAT(
      convert({"cup", "--tables", "csv"}),
      Exits(73, "cls: csv/matches/1/match.tracking.csv: exists; use --force to replace it\n"));
  EXPECT_EQ(convert({"cup", "--tables", "csv", "--force"}).exit_code, 0);
}

TEST_F(ConvertTables, WritesTheCommonDataFormat) {
  put_log("rcg-v6-excerpt.rcg.gz", "cup/matches/1/match.rcg.gz");
  const CommandResult result = convert({"cup", "--cdf", "out", "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(json::parse(result.out)["cdf"], "out");
  const std::string stem = path("out/matches/1/match");
  const json sheet = json::parse(read_file(stem + ".match.json"));
  EXPECT_EQ(sheet["match"]["id"], "matches/1/match");
  EXPECT_EQ(json::parse(read_file(stem + ".meta.json"))["match"]["id"], "matches/1/match");
  const std::string frames = read_file(stem + ".tracking.jsonl");
  EXPECT_EQ(std::ranges::count(frames, '\n'), 25);
  EXPECT_TRUE(fs::exists(stem + ".event.jsonl"));
  EXPECT_EQ(convert({"cup", "--cdf", "out"}).exit_code, 73);
}

TEST_F(ConvertTables, OneTableNeedsOneLog) {
  put_log("rcg-v6-excerpt.rcg.gz", "one/match.rcg.gz");
  EXPECT_EQ(convert({"one", "a.tracking.csv"}).exit_code, 0);
  put_log("rcg-v4-excerpt.rcg.gz", "one/other.rcg.gz");
  EXPECT_THAT(convert({"one", "b.tracking.csv"}),
              Exits(66, "cls: one: has 2 game logs; write their tables with --tables DIR\n"));
  fs::create_directories(path("none"));
  EXPECT_EQ(convert({"none", "b.tracking.csv"}).err, "cls: none: no game log in this folder\n");
  EXPECT_EQ(convert({"nowhere", "--tables", "csv"}).exit_code, 66);
  EXPECT_FALSE(fs::exists(path("b.tracking.csv")));
}

TEST_F(ConvertTables, LogsOfOneNameCannotShareTables) {
  put_log("rcg-v6-excerpt.rcg.gz", "a/match.rcg.gz");
  put_log("rcg-v4-excerpt.rcg.gz", "b/match.rcg.gz");
  EXPECT_THAT(
      convert({"?/*.rcg.gz", "--tables", "csv"}),
      Exits(2,
            "cls: a/match.rcg.gz and b/match.rcg.gz would have the same files; name their folder, "
            "whose sub-folders they keep\n"));
  EXPECT_FALSE(fs::exists(path("csv")));
}

TEST_F(ConvertTables, ReadsPages) {
  const std::string game = log("rcg-v6-excerpt.rcg.gz");
  run({cls_binary().string(), "watch", game, "--out", path("page.html")});
  for (const std::string table : {"tracking", "player_types", "event"}) {
    EXPECT_EQ(convert({"page.html", "-", "--to", table}).out,
              convert({game, "-", "--to", table}).out);
  }
}

TEST_F(ConvertTables, ConvertsReadableFramesOfACorruptLog) {
  const std::string whole = read_file(log("rcg-v5-excerpt.rcg.gz"));
  std::ofstream(path("cut.rcg")) << whole.substr(0, 90000);
  std::ofstream(path("bad.rcg")) << "hello";
  const CommandResult cut = convert({"cut.rcg", "-", "--to", "tracking"});
  EXPECT_EQ(cut.exit_code, 65);
  EXPECT_THAT(cut.err, HasSubstr("cut.rcg: line"));
  const std::string all = convert({log("rcg-v5-excerpt.rcg.gz"), "-", "--to", "tracking"}).out;
  EXPECT_GT(cut.out.size(), all.size() / 10);
  EXPECT_THAT(all, StartsWith(cut.out));
  const CommandResult bad = convert({"bad.rcg", "bad.tracking.csv"});
  EXPECT_EQ(bad.exit_code, 65);
  EXPECT_EQ(bad.err, "cls: bad.rcg: byte 0, cycle 0: not a game log (rcg)\n");
  EXPECT_FALSE(fs::exists(path("bad.tracking.csv")));
  EXPECT_FALSE(fs::exists(path("partial-bad.tracking.csv")));
}

// From the log to a page and back, the height of the ball stays.
TEST_F(ConvertTables, KeepsTheHeightOfVersion7) {
  std::string high = read_file(log("rcg-v6-excerpt.rcg.gz"));
  high[3] = '7';
  for (std::size_t at = high.find("((b)"); at != std::string::npos;
       at = high.find("((b)", at + 4)) {
    high.insert(high.find(')', at + 4), " 0.5");
  }
  std::ofstream(path("high.rcg")) << high;
  EXPECT_THAT(convert({"high.rcg", "-", "--to", "tracking"}).out, HasSubstr(",b_z\n1,"));

  Command({cls_binary().string(), "watch", "high.rcg", "--out", "page.html"}, {}, folder_.path())
      .finish();
  EXPECT_EQ(convert({"page.html", "again.rcg"}).exit_code, 0);
  EXPECT_EQ(read_file(path("again.rcg")), high);
  EXPECT_EQ(convert({"high.rcg", "flat.rcg"}).exit_code, 0);
  EXPECT_EQ(read_file(path("flat.rcg")), read_file(log("rcg-v6-excerpt.rcg.gz")));

  std::ofstream(path("next.rcg")) << "ULG8\n" << high.substr(5);
  const CommandResult next = convert({"next.rcg", "x.rcg"});
  EXPECT_EQ(next.exit_code, 65);
  EXPECT_EQ(next.err,
            "cls: next.rcg: byte 0, cycle 0: game log (rcg) of version 8, which this cls does not "
            "know: it reads 1 to 7 and JSON; a newer cls may read it\n");
}

TEST_F(ConvertTables, RefusesArgumentsThatDoNotFit) {
  const std::string game = log("rcg-v6-excerpt.rcg.gz");
  EXPECT_EQ(convert({game}).err,
            "cls: convert: name OUT, or a folder with --tables DIR or --cdf DIR\n");
  EXPECT_EQ(convert({game, "x.rcg", "--tables", "csv"}).err,
            "cls: convert: only one of OUT, --tables DIR and --cdf DIR\n");
  EXPECT_EQ(convert({game, "x.event.csv", "--published"}).err,
            "cls: --published: only for tracking tables\n");
  const CommandResult both = convert({game, "--tables", "csv", "--to", "event"});
  EXPECT_EQ(both.err, "cls: --to: --tables and --cdf write all files; name OUT for one table\n");
  EXPECT_EQ(both.exit_code, 2);
  std::ofstream(path("mine.event.csv")) << "mine";
  EXPECT_EQ(convert({game, "mine.event.csv"}).err,
            "cls: mine.event.csv: exists; use --force to replace it\n");
  EXPECT_EQ(read_file(path("mine.event.csv")), "mine");
}

// The program to compare with: of CLS_RCG2CSV, else on PATH.
std::string rcg2csv() {
  if (const char* named = std::getenv("CLS_RCG2CSV")) return named;
  const CommandResult found = run({"/bin/sh", "-c", "command -v rcg2csv"});
  return found.out.substr(0, found.out.find('\n'));
}

TEST_F(ConvertTables, HasTheBytesOfRcg2csv) {
  const std::string program = rcg2csv();
  if (program.empty()) GTEST_SKIP() << "no rcg2csv of librcsc: set CLS_RCG2CSV";
  std::vector<std::string> logs;
  for (const char* name : {"rcg-v4-excerpt", "rcg-v5-excerpt", "rcg-v6-excerpt", "match-start",
                           "rcg-json-excerpt", "recorded-messages-excerpt"}) {
    logs.push_back(log(std::string(name) + ".rcg.gz"));
  }

  for (const char* name : {"logs/helios-vs-helios-full.rcg.gz", "logs/cyrus-vs-helios-full.rcg.gz",
                           "noise-free/game.rcg.gz"}) {
    if (const auto file = data(name)) logs.push_back(file->string());
  }

  for (const std::string& game : logs) {
    SCOPED_TRACE(game);
    fs::copy_file(game, path("game.rcg.gz"), fs::copy_options::overwrite_existing);
    run({program, path("game.rcg.gz")});
    for (const std::string table : {"tracking", "player_types"}) {
      const CommandResult ours = convert({"game.rcg.gz", "-", "--to", table});
      EXPECT_TRUE(ours.out == read_file(path("game." + table + ".csv"))) << table;
    }
  }
}

}  // namespace
}  // namespace cls::tests
