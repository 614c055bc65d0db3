// End-to-end tests of the commands that read logs: results, stats, watch, report, convert.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using json = base::Json;

CommandResult cls_run(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), cls_binary());
  return run(arguments);
}

std::string log_fixture(const std::string& name) { return fixture("gamelog/" + name).string(); }

TEST(ResultsCommand, PrintsDocumentWithRowPerMatch) {
  const CommandResult result = cls_run({"results", "--json", log_fixture("rcg-v4-excerpt.rcg.gz"),
                                        log_fixture("rcg-v1-excerpt.rcg.gz")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const json document = json::parse(result.out);
  EXPECT_EQ(document["schema"], "cls.results/1");
  ASSERT_EQ(document["matches"].size(), 2u);
  EXPECT_EQ(document["matches"][0]["left"]["name"], "HELIOS_L");
  EXPECT_EQ(document["matches"][0]["winner"], "draw");
  EXPECT_EQ(document["matches"][1]["winner"], "left");
  EXPECT_EQ(document["matches"][1]["cycles"], 400);
}

TEST(ResultsCommand, SaysThatStandardInputIsClosed) {
  EXPECT_THAT(run({"sh", "-c", "exec " + cls_binary().string() + " results - <&-"}),
              Exits(66, HasSubstr("standard input is closed\n")));
}

TEST(ResultsCommand, ReadsFoldersAndPrintsTables) {
  for (const char* format : {"table", "csv", "markdown"}) {
    const CommandResult result =
        cls_run({"results", fixture("gamelog").string(), "--format", format, "--jobs", "2"});
    EXPECT_EQ(result.exit_code, 65) << result.err;  // one of them is truncated
    EXPECT_THAT(result.out, HasSubstr("HELIOS"));
    EXPECT_THAT(result.err,
                HasSubstr("match-start.rcg.gz: line 312, byte 932854, cycle 234: no end of the "
                          "match: the log is incomplete"));
  }
}

TEST(ResultsCommand, ReportsParseErrorsAndUsesFramesBefore) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "cut.rcg";
  std::ofstream(path) << read_file(fixture("gamelog/match-start.rcg.gz")).substr(0, 700000);
  const CommandResult result = cls_run({"results", path, "--json"});
  EXPECT_EQ(result.exit_code, 65);
  EXPECT_THAT(result.err, HasSubstr("cut.rcg: line 239, byte 700000, cycle 169: truncated log"));
  const json match = json::parse(result.out)["matches"][0];
  EXPECT_EQ(match["left"]["score"], 1);
  EXPECT_EQ(match["goals"][0]["cycle"], 169);
  EXPECT_EQ(match["goals"][0]["unum"], 11);
  EXPECT_EQ(match["complete"], false);
  EXPECT_TRUE(match["winner"].is_null());
}

TEST(ResultsCommand, ReadsRunningMatchesAndNamesLogsInFull) {
  const TemporaryFolder folder;
  const std::string log = read_file(log_fixture("rcg-v6-excerpt.rcg.gz"));
  const std::string name = "20261123T193600Z-a-long-name-of-a-team-against-another-one";
  for (const std::string& match : {name, name + "-2"}) {
    fs::create_directories(folder.path() / match);
    // The last line is being written.
    std::ofstream(folder.path() / match / "match.rcg") << log.substr(0, log.size() * 2 / 3);
  }

  std::ofstream(folder.path() / name / "manifest.json") << R"({"started": "x", "ended": null})";
  std::ofstream(folder.path() / (name + "-2") / "manifest.json")
      << R"({"started": "x", "ended": "2026-11-23T19:36:00Z"})";
  const CommandResult result = cls_run({"results", folder.path().string()});
  EXPECT_EQ(result.exit_code, 65) << "the other one is truncated";
  EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr(name + "-2/match.rcg: line"));
  EXPECT_THAT(result.out, HasSubstr(name + "\n"));
  EXPECT_THAT(result.out, HasSubstr("running"));

  fs::remove_all(folder.path() / (name + "-2"));
  EXPECT_EQ(cls_run({"results", folder.path().string()}).exit_code, 0);
}

TEST(ResultsCommand, ReportsTruncatedGzipOnce) {
  const TemporaryFolder folder;
  for (const char* ending : {".rcg.gz", ".rcl.gz"}) {
    const std::string path = folder.path() / (std::string("cut") + ending);
    fs::copy_file(fixture(std::string("gamelog/match-start") + ending), path);
    fs::resize_file(path, fs::file_size(path) / 2);
    const CommandResult result = cls_run({"results", path});
    EXPECT_EQ(result.exit_code, 65);
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    EXPECT_THAT(result.err, HasSubstr("truncated log: gzip data is truncated"));
    EXPECT_THAT(result.out, HasSubstr("incomplete"));
  }
}

TEST(ResultsCommand, ReportsMissingAndInvalidLogs) {
  const TemporaryFolder folder;
  const CommandResult missing = cls_run({"results", "nowhere.rcg"});
  EXPECT_EQ(missing.exit_code, 66);
  EXPECT_EQ(missing.err, "cls: nowhere.rcg: no such log\n");
  EXPECT_EQ(missing.out, "");
  const std::string path = folder.path() / "x.rcg";
  std::ofstream(path) << "hello";
  const CommandResult none = cls_run({"results", path});
  EXPECT_EQ(none.exit_code, 65);
  EXPECT_EQ(none.err, "cls: " + path + ": byte 0, cycle 0: not a game log (rcg)\n");
  EXPECT_EQ(none.out, "");
  EXPECT_EQ(cls_run({"results"}).exit_code, 2);
  EXPECT_EQ(cls_run({"results", path, "--format", "xml"}).exit_code, 2);
}

TEST(ConvertCommand, ConvertsBetweenVersions) {
  const TemporaryFolder folder;
  const std::string original = log_fixture("rcg-v6-excerpt.rcg.gz");
  const std::string as_json = folder.path() / "a.json.gz";
  const std::string again = folder.path() / "b.rcg";
  EXPECT_EQ(cls_run({"convert", original, as_json}).exit_code, 0);
  EXPECT_EQ(read_file(as_json).substr(0, 2), "[\n");
  EXPECT_EQ(cls_run({"convert", as_json, again}).exit_code, 0);
  EXPECT_EQ(read_file(again), read_file(original));
  const CommandResult old =
      cls_run({"convert", log_fixture("rcg-v1-excerpt.rcg.gz"), "-", "--to", "4"});
  EXPECT_EQ(old.exit_code, 0);
  EXPECT_EQ(old.out.substr(0, 5), "ULG4\n");
}

TEST(WatchCommand, WritesPagesThatAreLogs) {
  const TemporaryFolder folder;
  for (const std::string name : {"rcg-v4-excerpt", "rcg-v5-excerpt", "rcg-v6-excerpt",
                                 "rcg-json-excerpt", "team-graphic-v6-excerpt"}) {
    SCOPED_TRACE(name);
    const std::string log = log_fixture(name + ".rcg.gz");
    const std::string page = folder.path() / (name + ".html");
    const CommandResult written = cls_run({"watch", log, "--out", page});
    EXPECT_EQ(written.out, page + "\n") << written.err;
    const std::string again = folder.path() / (name + ".rcg");
    cls_run({"convert", page, again});
    EXPECT_EQ(read_file(again), read_file(log));
  }
}

TEST(WatchCommand, GivesWholeMatchesBackByteForByte) {
  for (const std::string name : {"helios-vs-helios-full", "cyrus-vs-helios-full"}) {
    const auto log = data("logs/" + name + ".rcg.gz");
    if (!log) GTEST_SKIP() << "no data: set CLS_DATA";
    const TemporaryFolder folder;
    const std::string page = folder.path() / "page.html";
    EXPECT_EQ(cls_run({"watch", log->string(), "--out", page}).exit_code, 0);
    EXPECT_LE(fs::file_size(page), 1'700'000U);
    const std::string again = folder.path() / "again.rcg";
    EXPECT_EQ(cls_run({"convert", page, again}).exit_code, 0);
    EXPECT_TRUE(read_file(again) == read_file(*log)) << name;
  }
}

TEST(WatchCommand, WritesBesideTheLogAndReplacesPagesOnly) {
  const TemporaryFolder folder;
  const fs::path log = folder.path() / "game.rcg.gz";
  fs::copy_file(log_fixture("match-start.rcg.gz"), log);
  const CommandResult first = cls_run({"watch", log, "--no-open"});
  EXPECT_EQ(first.out, "file://" + (folder.path() / "game.html").string() + "\n");
  EXPECT_EQ(cls_run({"watch", log, "--no-open"}).out, first.out);
  const std::string note = folder.path() / "note.html";
  std::ofstream(note) << "mine";
  const CommandResult refused = cls_run({"watch", log, "--out", note});
  EXPECT_EQ(refused.exit_code, 73);
  EXPECT_EQ(
      refused.err,
      "cls: " + note + ": exists and is not a page of cls; name another file with " + "--out\n");
  EXPECT_EQ(read_file(note), "mine");
}

TEST(ReportCommand, WritesOneFileThatIsALog) {
  const TemporaryFolder folder;
  const std::string log = log_fixture("rcg-v6-excerpt.rcg.gz");
  const std::string report = folder.path() / "report.html";
  EXPECT_THAT(cls_run({"report", log, "--out", report}), Prints(0, testing::Eq(report + "\n")));
  const std::string again = folder.path() / "again.rcg";
  EXPECT_EQ(cls_run({"convert", report, again}).exit_code, 0);
  EXPECT_EQ(read_file(again), read_file(log));
  const std::uintmax_t size = fs::file_size(report);
  EXPECT_EQ(cls_run({"report", log, "--out", report, "--no-replay"}).exit_code, 0);
  EXPECT_LT(fs::file_size(report), 120'000U);
  EXPECT_GT(size, fs::file_size(report));
}

TEST(ReportCommand, WritesMarkdownWithImagesAndImagesAlone) {
  const TemporaryFolder folder;
  const fs::path log = folder.path() / "game.rcg.gz";
  fs::copy_file(log_fixture("rcg-v5-excerpt.rcg.gz"), log);
  const json written = json::parse(cls_run({"report", log, "--format", "md", "--json"}).out);
  EXPECT_EQ(written["schema"], "cls.report/1");
  EXPECT_EQ(written["files"][0], (folder.path() / "game-report.md").string());
  for (const json& file : written["files"])
    EXPECT_TRUE(fs::exists(file.get<std::string>())) << file;
  const std::string text = read_file(folder.path() / "game-report.md");
  EXPECT_THAT(text, HasSubstr("](game-report-charts/shots.svg)"));
  EXPECT_TRUE(read_file(folder.path() / "game-report-charts/shots.svg").starts_with("<svg "));
  const CommandResult images =
      cls_run({"report", log, "--format", "svg", "--out", folder.path() / "images"});
  EXPECT_EQ(images.exit_code, 0) << images.err;
  EXPECT_EQ(read_file(folder.path() / "images/shots.svg"),
            read_file(folder.path() / "game-report-charts/shots.svg"));
}

TEST(ReportCommand, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string log = log_fixture("rcg-v6-excerpt.rcg.gz");
  const CommandResult format = cls_run({"report", log, "--format", "pdf"});
  EXPECT_EQ(format.exit_code, 2);
  EXPECT_EQ(format.err, "cls: --format 'pdf': must be html, md or svg\n");
  EXPECT_EQ(cls_run({"report", "nowhere.rcg"}).exit_code, 66);
  const std::string empty = folder.path() / "empty.rcg";
  std::ofstream(empty) << "";
  EXPECT_EQ(cls_run({"report", empty}).exit_code, 65);
  const std::string note = folder.path() / "note.html";
  std::ofstream(note) << "mine";
  EXPECT_EQ(cls_run({"report", log, "--out", note}).exit_code, 73);
  EXPECT_EQ(read_file(note), "mine");
  const std::string nowhere = folder.path() / "note.html/report.html";
  EXPECT_EQ(cls_run({"report", log, "--out", nowhere}).exit_code, 73);
}

TEST(WatchCommand, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string page = folder.path() / "page.html";
  const std::string log = log_fixture("rcg-v6-excerpt.rcg.gz");
  EXPECT_THAT(cls_run({"watch", "nowhere.rcg"}), Exits(66, "cls: nowhere.rcg: no such file\n"));
  EXPECT_THAT(cls_run({"watch", log, "--out", page, "--players", "l7,x3"}),
              Exits(2, "cls: --players 'x3': must be l1 to l11 or r1 to r11, such as l7,r1\n"));
  EXPECT_EQ(cls_run({"watch", log_fixture("match-start.rcl.gz")}).exit_code, 66);
  EXPECT_EQ(cls_run({"watch", log, "--out", page, "--compact"}).exit_code, 0);
  const CommandResult compact = cls_run({"convert", page, folder.path() / "again.rcg"});
  EXPECT_EQ(compact.exit_code, 65);
  EXPECT_EQ(compact.err,
            "cls: " + page + ": a compact page, which is not a log; write it without --compact\n");
  fs::resize_file(page, fs::file_size(page) - 1000);
  EXPECT_THAT(cls_run({"watch", page, "--out", folder.path() / "other.html"}),
              Exits(65, HasSubstr("% of the match is there")));
}

TEST(ConvertCommand, ConvertsReadableFramesOfCorruptLog) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "cut.rcg";
  const std::string whole = read_file(fixture("gamelog/rcg-v5-excerpt.rcg.gz"));
  std::ofstream(path) << whole.substr(0, 90000);
  const CommandResult result = cls_run({"convert", path, "-", "--to", "5"});
  EXPECT_EQ(result.exit_code, 65);
  EXPECT_THAT(result.err, HasSubstr("truncated log"));
  EXPECT_EQ(result.out, whole.substr(0, whole.rfind('\n', 90000) + 1));
}

TEST(ConvertCommand, ReportsFailuresByExitCode) {
  const TemporaryFolder folder;
  const std::string log = log_fixture("rcg-v6-excerpt.rcg.gz");
  EXPECT_EQ(cls_run({"convert", "nowhere.rcg", "-"}).exit_code, 66);
  EXPECT_EQ(cls_run({"convert", log, folder.path() / "no" / "x.rcg"}).exit_code, 73);
  EXPECT_EQ(cls_run({"convert", log, "/dev/full"}).exit_code, 74);
  EXPECT_THAT(
      cls_run({"convert", log, "-", "--to", "3"}),
      Exits(2, "cls: --to '3': must be 4, 5, 6, 7, json, tracking, player_types or event\n"));
  EXPECT_EQ(cls_run({"convert", log}).exit_code, 2);
}

TEST(ConvertCommand, RefusesAnEndingThatNamesNoFormat) {
  const TemporaryFolder folder;
  const std::string log = log_fixture("rcg-v6-excerpt.rcg.gz");
  for (const char* name : {"game.tracking.txt", "game.rcl", "game", "game.gz"}) {
    const std::string out = folder.path() / name;
    EXPECT_THAT(cls_run({"convert", log, out}),
                Exits(2, HasSubstr(".rcg, .rcg.gz, .json, .json.gz, .tracking.csv, "
                                   ".player_types.csv, .event.csv or --to\n")));
    EXPECT_FALSE(std::filesystem::exists(out)) << name;
    EXPECT_EQ(cls_run({"convert", log, out, "--to", "5"}).exit_code, 0) << name;
  }
}

TEST(ConvertCommand, WritesIntoLinksAndPipes) {
  const TemporaryFolder folder;
  const std::string log = log_fixture("rcg-v6-excerpt.rcg.gz");
  const std::string link = folder.path() / "link.rcg";
  std::filesystem::create_symlink("real.rcg", link);
  EXPECT_EQ(cls_run({"convert", log, link}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(cls_run({"convert", log, link}).exit_code, 73) << "the file exists";
  const std::string piped = folder.path() / "piped.rcg";
  const CommandResult result =
      run({"/bin/bash", "-c",
           cls_binary().string() + " convert " + log + " >(cat >" + piped + "); sleep 1"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read_file(piped), read_file(folder.path() / "real.rcg"));
}

TEST(StatsCommand, PrintsSpadlActions) {
  const std::string log = log_fixture("match-start.rcg.gz");
  const CommandResult result = cls_run({"stats", log, "--events", "--format", "spadl"});
  EXPECT_EQ(result.exit_code, 65);  // truncated log
  EXPECT_EQ(result.out.substr(0, 34), "game_id,original_event_id,action_i");
  EXPECT_THAT(result.out, HasSubstr("\n" + log + ",0,0,1,3.1,HELIOS_L,HELIOS_L_"));
  EXPECT_THAT(result.out, HasSubstr(",shot,1,success,0,foot\n"));
}

TEST(StatsCommand, PrintsDocumentOfItsSchema) {
  const CommandResult result =
      cls_run({"stats", "--json", "--events", log_fixture("match-start.rcg.gz")});
  EXPECT_EQ(result.exit_code, 65);  // truncated log
  const json document = json::parse(result.out);
  EXPECT_EQ(document["schema"], "cls.stats/1");
  ASSERT_EQ(document["matches"].size(), 1u);

  const json& match = document["matches"][0];
  EXPECT_EQ(match["text_log"], log_fixture("match-start.rcl.gz"));
  EXPECT_EQ(match["left"]["name"], "HELIOS_L");
  EXPECT_EQ(match["left"]["shots"]["goal"], 1);
  EXPECT_EQ(match["goals"][0]["unum"], 11);
  EXPECT_EQ(match["goals"][0]["assist"], 10);
  EXPECT_NEAR(match["goals"][0]["minute"].get<double>(), 169.0 / 6000 * 90, 1e-4);
  EXPECT_EQ(match["goals"][0]["from_set_play"], false);
  EXPECT_EQ(match["players"].size(), 22u);
  EXPECT_EQ(match["players"][9]["responsiveness"]["silent"], 0);
  EXPECT_EQ(match["players"][9]["heat"].size(), 21u * 14u);
  EXPECT_GT(match["events"].size(), 20u);

  const json& pass = match["events"][0];
  EXPECT_EQ(pass["kind"], "pass");
  EXPECT_EQ(pass["result"], "completed");
  EXPECT_NEAR(pass["length"].get<double>(), std::hypot(2.0648, 0.2687), 1e-3);
  EXPECT_EQ(match["doubts"][0], "no time_over");

  const auto left = match["left"]["possession"]["last_touch"].get<double>();
  const auto right = match["right"]["possession"]["last_touch"].get<double>();
  EXPECT_NEAR(left + right, 1.0, 1e-9);
}

TEST(StatsCommand, PrintsTextAndRows) {
  const std::string log = log_fixture("rcg-v6-excerpt.rcg.gz");
  const CommandResult text = cls_run({"stats", log});
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_EQ(text.out.substr(0, text.out.find('(')), "HELIOS_L 0:0 HELIOS_R  ");
  EXPECT_THAT(text.out, HasSubstr("possession (last touch)"));

  struct Rows {
    const char* format;
    int lines;
  };
  for (const auto& [format, lines] : {Rows{"csv", 5}, Rows{"csv-players", 45}}) {
    const CommandResult rows =
        cls_run({"stats", log, log_fixture("rcg-json-excerpt.rcg.gz"), "--format", format});
    EXPECT_EQ(rows.exit_code, 0) << rows.err;
    EXPECT_EQ(std::ranges::count(rows.out, '\n'), lines);
  }

  EXPECT_EQ(cls_run({"stats", log, "--format", "csv-events"}).out.substr(0, 23),
            "file,cycle,stopped,kind");
}

TEST(StatsCommand, RequiresGameLog) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "alone.rcl";
  std::ofstream(path) << "1,0\t(referee play_on)\n";
  EXPECT_THAT(cls_run({"stats", path}),
              Exits(66, "cls: " + path + ": no game log (rcg) beside it\n"));
  EXPECT_EQ(cls_run({"stats", "nowhere"}).exit_code, 66);
  EXPECT_EQ(cls_run({"stats", path, "--format", "pdf"}).exit_code, 2);
}

}  // namespace
}  // namespace cls::tests
