// Result tables as users and programs see them, and the logs that arguments stand for.
#include "analysis/results/results_text.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "analysis/results/read_results.h"
#include "base/system/parallel.h"
#include "base/text/text_table.h"
#include "gamelog/files/log_files.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::analysis {
namespace {

namespace fs = std::filesystem;
using soccer::Side;

MatchSummary example() {
  MatchSummary match;
  match.file = "logs/a,b.rcg";
  match.version = "6";
  match.date = "202611202127";
  match.teams[0] = {"A|b", 1, 1, 0, 0};
  match.teams[1] = {"\xc3\x9c", 2, 0, 0, 0};
  match.winner = Winner::kRight;
  match.complete = true;
  match.cycles = 6000;
  match.frames = 6400;
  match.goals = {
      {169, Side::kLeft, 11, false}, {1313, Side::kRight, 4, true}, {1400, Side::kRight, 0, false}};
  match.cards = {{{2069, Side::kLeft, 7}, false}};
  match.substitutions = {{{5716, Side::kRight, 7}, 13, 6}};
  return match;
}

TEST(ResultsText, PrintsATable) {
  EXPECT_EQ(format_results({example()}, ResultsFormat::kTable),
            "left  score  right  winner  cycles  goals                             remarks"
            "                  log\n"
            "A|b     1:2  \xc3\x9c      \xc3\x9c         6000  169 l 11; 1313 r 4 own; 1400 r ?  "
            "1 yellow, 1 substituted  a,b.rcg\n");
}

TEST(ResultsText, AddsTheTableOfTeamsToSeveralMatches) {
  MatchSummary open = example();
  open.winner = Winner::kNone;
  const std::string text = format_results({example(), example(), open}, ResultsFormat::kTable);
  EXPECT_NE(text.find("\n\nteam  played  won  drawn  lost  goals  difference  points\n"
                      "\xc3\x9c          2    2      0     0    4:2          +2       6\n"
                      "A|b        2    0      0     2    2:4          -2       0\n"
                      "\n1 incomplete not counted\n"),
            std::string::npos)
      << text;
}

TEST(ResultsText, EscapesMarkdown) {
  const std::string text = format_results({example()}, ResultsFormat::kMarkdown);
  EXPECT_NE(text.find("| left | score | right |"), std::string::npos) << text;
  EXPECT_NE(text.find("|---|--:|---|"), std::string::npos);
  EXPECT_NE(text.find("| A\\|b | 1:2 |"), std::string::npos) << text;
}

TEST(ResultsText, QuotesCsv) {
  EXPECT_EQ(format_results({example()}, ResultsFormat::kCsv),
            "file,date,version,left,right,left_score,right_score,left_penalties,right_penalties,"
            "winner,complete,cycles,goals,cards,substitutions,disconnections,late_starts,"
            "never_connected,damage,end_reason\n"
            "\"logs/a,b.rcg\",202611202127,6,A|b,\xc3\x9c,1,2,,,right,true,6000,"
            "169 l 11; 1313 r 4 own; 1400 r ?,2069 l 7,5716 r 7 13>6,,,,0,\n");
}

TEST(ResultsText, WritesJsonByTheContract) {
  MatchSummary match = example();
  match.teams[0].name = "bad\xff";
  const auto json = nlohmann::json::parse(format_results({match}, ResultsFormat::kJson));
  EXPECT_EQ(json["schema"], "cls.results/1");
  const auto& row = json["matches"][0];
  EXPECT_EQ(row["file"], "logs/a,b.rcg");
  EXPECT_EQ(row["left"]["name"], "bad\xef\xbf\xbd");
  EXPECT_EQ(row["left"]["score"], 1);
  EXPECT_TRUE(row["left"]["penalty_score"].is_null());
  EXPECT_EQ(row["right"]["score"], 2);
  EXPECT_EQ(row["winner"], "right");
  EXPECT_EQ(row["cycles"], 6000);
  EXPECT_EQ(row["complete"], true);
  EXPECT_EQ(row["goals"][0]["cycle"], 169);
  EXPECT_EQ(row["goals"][0]["side"], "left");
  EXPECT_EQ(row["goals"][0]["unum"], 11);
  EXPECT_EQ(row["goals"][1]["own_goal"], true);
  EXPECT_TRUE(row["goals"][2]["unum"].is_null());
  EXPECT_EQ(row["cards"][0]["card"], "yellow");
  EXPECT_EQ(row["substitutions"][0]["to_type"], 6);
  EXPECT_EQ(json["standings"][0]["points"], 3);
}

TEST(TextTable, KeepsControlCharactersOutOfTheTerminal) {
  base::TextTable table;
  table.add_column("a");
  table.add_row({"x\x1b[31m\ny"});
  EXPECT_EQ(table.plain(), "a\nx?[31m?y\n");
}

class LogFolder : public testing::Test {
 protected:
  std::string make(const std::string& name) {
    const fs::path path = folder_.path() / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << "x";
    return path.string();
  }
  std::string folder() const { return folder_.path().string(); }

  tests::TemporaryFolder folder_;
};

TEST_F(LogFolder, PairsTheLogsOfAMatch) {
  const std::string game = make("b/game-vs-x.rcg.gz");
  const std::string text = make("b/game-vs-x.rcl");
  const std::string alone = make("a.rcl.gz");
  make("notes.txt");
  const gamelog::FoundLogs found = gamelog::find_logs({folder()});
  ASSERT_EQ(found.matches.size(), 2u);
  EXPECT_EQ(found.matches[0].game, "");
  EXPECT_EQ(found.matches[0].text, alone);
  EXPECT_EQ(found.matches[1].game, game);
  EXPECT_EQ(found.matches[1].text, text);
  const gamelog::FoundLogs named = gamelog::find_logs({game});
  EXPECT_EQ(named.matches.at(0).text, text);
  EXPECT_EQ(gamelog::find_logs({text, game}).matches.size(), 1u);
}

TEST_F(LogFolder, UnderstandsPatternsAndNamesWhatIsMissing) {
  make("1.rcg");
  make("2.rcg");
  make("sub/3.rcg");
  EXPECT_EQ(gamelog::find_logs({folder() + "/?.rcg"}).matches.size(), 2u);
  EXPECT_EQ(gamelog::find_logs({folder() + "/*"}).matches.size(), 3u);
  const gamelog::FoundLogs none =
      gamelog::find_logs({folder() + "/9.rcg", folder() + "/*.rcl", "-"});
  EXPECT_EQ(none.missing.size(), 2u);
  ASSERT_EQ(none.matches.size(), 1u);
  EXPECT_EQ(none.matches[0].game, "-");
}

TEST_F(LogFolder, TakesAPatternThatIsAFileAsThatFile) {
  const std::string odd = make("a[1].rcg");
  make("a1.rcg");
  const gamelog::FoundLogs found = gamelog::find_logs({odd});
  ASSERT_EQ(found.matches.size(), 1u);
  EXPECT_EQ(found.matches[0].game, odd);
}

// The start of a match: 1:0 after 234 cycles, without an end.
class MatchBesideItsDocument : public testing::Test {
 protected:
  MatchSummary read(const std::string& document) {
    const fs::path folder = folder_.path();
    std::ofstream(folder / "match.rcg")
        << tests::read_file(tests::fixture("gamelog/match-start.rcg.gz"));
    std::ofstream(folder / "result.json") << document;
    const auto results =
        read_results(gamelog::find_logs({(folder / "match.rcg").string()}).matches, 1);
    return results.at(0).summary;
  }

  static std::string document(const std::string& end_reason, const std::string& log) {
    return R"({"schema": "cls.match/1", "end_reason": ")" + end_reason +
           R"(", "log_files": {"rcg": ")" + log + R"(", "rcl": "match.rcl"}})";
  }

  tests::TemporaryFolder folder_;
};

TEST_F(MatchBesideItsDocument, IsCompleteIfItWasMeantToEndThere) {
  const MatchSummary summary = read(document("finished", "match.rcg"));
  EXPECT_TRUE(summary.complete);
  EXPECT_EQ(summary.end_reason, "finished");
  EXPECT_EQ(summary.winner, Winner::kLeft);
  EXPECT_NE(format_results({summary}, ResultsFormat::kJson).find("\"end_reason\": \"finished\""),
            std::string::npos);
}

TEST_F(MatchBesideItsDocument, SaysWhyItBrokeOff) {
  const MatchSummary summary = read(document("stalled", "match.rcg"));
  EXPECT_FALSE(summary.complete);
  EXPECT_EQ(summary.winner, Winner::kNone);
  const std::string table = format_results({summary}, ResultsFormat::kTable);
  EXPECT_NE(table.find("incomplete"), std::string::npos);
  EXPECT_NE(table.find("stalled, "), std::string::npos) << table;
}

TEST_F(MatchBesideItsDocument, DoesNotBelieveADocumentOfSomethingElse) {
  for (const std::string& odd :
       {document("finished", "another.rcg"), std::string("{\"schema\": \"cls.match/1\"}"),
        std::string("[1]"), std::string("no json"),
        std::string("{\"schema\": 5, \"log_files\": 7}"),
        std::string("{\"schema\": \"cls.match/1\", \"log_files\": []}")}) {
    const MatchSummary summary = read(odd);
    EXPECT_FALSE(summary.complete) << odd;
    EXPECT_EQ(summary.end_reason, "") << odd;
  }
}

TEST(ResultsText, NamesLogsByTheirPathWhereFilesHaveOneName) {
  MatchSummary a = example();
  a.file = "runs/5/a/match.rcg";
  MatchSummary b = example();
  b.file = "runs/5/bb/match.rcg";
  const std::string table = format_results({a, b}, ResultsFormat::kTable);
  EXPECT_NE(table.find("  a/match.rcg\n"), std::string::npos) << table;
  EXPECT_NE(table.find("  bb/match.rcg\n"), std::string::npos) << table;
}

TEST(ReadResults, KnowsATextLogByItsBytes) {
  const tests::TemporaryFolder folder;
  const std::string path = folder.path() / "some-log.txt";
  std::ofstream(path) << "0,1\tRecv A_1: (init A (version 18))\n1,0\t(referee play_on)\n"
                         "50,0\t(referee goal_l_1)\n6000,0\t(referee time_over)\n";
  const auto results = read_results(gamelog::find_logs({path}).matches, 1);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_TRUE(results[0].damage.empty());
  EXPECT_EQ(results[0].summary.version, "rcl");
  EXPECT_EQ(results[0].summary.winner, Winner::kLeft);
}

TEST(ReadResults, GivesTheSameOnOneThreadAndOnFour) {
  std::vector<gamelog::MatchLogs> logs;
  for (int i = 0; i < 3; ++i) {
    for (const char* name : {"rcg-v4-excerpt", "rcg-json-excerpt", "rcg-v1-excerpt"}) {
      logs.push_back({tests::fixture("gamelog/" + std::string(name) + ".rcg.gz").string(), ""});
    }
  }
  std::string expected;
  for (const std::size_t jobs : {1, 4}) {
    std::vector<MatchSummary> summaries;
    for (const ReadResult& result : read_results(logs, jobs)) {
      EXPECT_TRUE(result.usable);
      EXPECT_TRUE(result.damage.empty());
      summaries.push_back(result.summary);
    }
    const std::string text = format_results(summaries, ResultsFormat::kJson);
    if (expected.empty()) expected = text;
    EXPECT_EQ(text, expected);
  }
}

TEST(ForEachIndex, DoesEveryPieceOfWorkOnce) {
  for (const std::size_t jobs : {0, 1, 3, 50}) {
    std::vector<int> done(20, 0);
    std::atomic<std::size_t> sum = 0;
    base::for_each_index(
        done.size(), jobs, [&done](std::size_t i) { ++done[i]; },
        [&sum](std::size_t so_far) { sum += so_far; });
    EXPECT_EQ(done, std::vector<int>(20, 1));
    EXPECT_EQ(sum, 20u * 21u / 2u);
  }
}

}  // namespace
}  // namespace cls::analysis
