// Result tables as text, Markdown, CSV and JSON, and reading results from logs.
#include "analysis/results/results_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "analysis/results/read_results.h"
#include "base/text/json.h"
#include "base/text/lines.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::analysis {
namespace {

using soccer::Side;
using testing::HasSubstr;
using testing::Not;

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

TEST(ResultsText, FormatsTable) {
  EXPECT_EQ(format_results({example()}, ResultsFormat::kTable, 120),
            "left  score  right  cycles  goals                             remarks"
            "                  log\n"
            "A|b     1:2  \xc3\x9c        6000  169 l 11; 1313 r 4 own; 1400 r ?  "
            "1 yellow, 1 substituted  a,b.rcg\n");
}

TEST(ResultsText, FitsEachMatchIntoOneLine) {
  MatchSummary tossed = example();
  tossed.teams[0].name = "FIFTEEN_CHARS_A";
  tossed.winner = Winner::kLeft;
  tossed.coin_toss = true;
  const std::string text = format_results({example(), tossed}, ResultsFormat::kTable);

  EXPECT_THAT(
      text, HasSubstr("\nA|b                1:2  \xc3\x9c        6000  169 l 11;...  1 yellow, "));
  EXPECT_THAT(text, HasSubstr("coin toss: FIFT..."));

  for (const std::string_view line : base::lines_of(text)) EXPECT_LE(line.size(), 82U) << line;
  MatchSummary plain = example();
  plain.cards.clear();
  plain.substitutions.clear();

  EXPECT_THAT(format_results({plain}, ResultsFormat::kTable), Not(HasSubstr("remarks")));
}

TEST(ResultsText, AppendsTeamTableForSeveralMatches) {
  MatchSummary open = example();
  open.winner = Winner::kNone;
  const std::string text = format_results({example(), example(), open}, ResultsFormat::kTable);
  EXPECT_THAT(text, HasSubstr("\n\nteam  played  won  drawn  lost  goals  difference  points\n"
                              "\xc3\x9c          2    2      0     0    4:2          +2       6\n"
                              "A|b        2    0      0     2    2:4          -2       0\n"
                              "\n1 incomplete not counted\n"));
}

TEST(ResultsText, EscapesMarkdown) {
  const std::string text = format_results({example()}, ResultsFormat::kMarkdown);
  EXPECT_THAT(text, HasSubstr("| left | score | right |"));
  EXPECT_THAT(text, HasSubstr("|---|--:|---|"));
  EXPECT_THAT(text, HasSubstr("| A\\|b | 1:2 |"));
}

TEST(ResultsText, QuotesCsv) {
  EXPECT_EQ(format_results({example()}, ResultsFormat::kCsv),
            "file,date,version,left,right,left_score,right_score,left_penalties,right_penalties,"
            "winner,complete,cycles,goals,cards,substitutions,disconnections,late_starts,"
            "never_connected,damage,end_reason\n"
            "\"logs/a,b.rcg\",202611202127,6,A|b,\xc3\x9c,1,2,,,right,true,6000,"
            "169 l 11; 1313 r 4 own; 1400 r ?,2069 l 7,5716 r 7 13>6,,,,0,\n");
}

TEST(ResultsText, FormatsJsonDocument) {
  MatchSummary match = example();
  match.teams[0].name = "bad\xff";
  const auto printed = base::Json::parse(format_results({match}, ResultsFormat::kJson));

  EXPECT_EQ(printed["schema"], "cls.results/1");

  const auto& row = printed["matches"][0];
  EXPECT_EQ(row["file"], "logs/a,b.rcg");
  EXPECT_EQ(row["winner"], "right");
  EXPECT_EQ(row["cycles"], 6000);
  EXPECT_EQ(row["complete"], true);
  EXPECT_EQ(row["left"]["name"], "bad\xef\xbf\xbd");
  EXPECT_EQ(row["left"]["score"], 1);
  EXPECT_TRUE(row["left"]["penalty_score"].is_null());
  EXPECT_EQ(row["right"]["score"], 2);
  EXPECT_EQ(row["goals"][0]["cycle"], 169);
  EXPECT_EQ(row["goals"][0]["side"], "left");
  EXPECT_EQ(row["goals"][0]["unum"], 11);
  EXPECT_EQ(row["goals"][1]["own_goal"], true);
  EXPECT_TRUE(row["goals"][2]["unum"].is_null());
  EXPECT_EQ(row["cards"][0]["card"], "yellow");
  EXPECT_EQ(row["substitutions"][0]["to_type"], 6);
  EXPECT_EQ(printed["standings"][0]["points"], 3);
}

TEST(ResultsText, ShowsPathsWhenFileNamesAreEqual) {
  MatchSummary a = example();
  a.file = "runs/5/a/match.rcg";
  MatchSummary b = example();
  b.file = "runs/5/bb/match.rcg";
  const std::string table = format_results({a, b}, ResultsFormat::kTable);
  EXPECT_THAT(table, HasSubstr("  a\n"));
  EXPECT_THAT(table, HasSubstr("  bb\n"));
  MatchSummary c = example();
  c.file = "runs/5/c/other.rcg";
  const std::string mixed = format_results({a, b, c}, ResultsFormat::kTable);
  EXPECT_THAT(mixed, HasSubstr("  a/match.rcg\n"));
  EXPECT_THAT(mixed, HasSubstr("  c/other.rcg\n"));
}

TEST(ReadResults, DetectsTextLogByFirstBytes) {
  const tests::TemporaryFolder folder;
  const std::string path = folder.path() / "some-log.txt";
  std::ofstream(path) << "0,1\tRecv A_1: (init A (version 18))\n1,0\t(referee play_on)\n"
                         "50,0\t(referee goal_l_1)\n6000,0\t(referee time_over)\n";
  const auto results = read_results({{{path, ""}, std::nullopt}}, 1);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_TRUE(results[0].errors.empty());
  EXPECT_EQ(results[0].summary.version, "rcl");
  EXPECT_EQ(results[0].summary.winner, Winner::kLeft);
}

TEST(ReadResults, GivesSameResultsOnOneAndFourThreads) {
  std::vector<MatchInput> inputs;
  for (int i = 0; i < 3; ++i) {
    for (const char* name : {"rcg-v4-excerpt", "rcg-json-excerpt", "rcg-v1-excerpt"}) {
      inputs.push_back(
          {{tests::fixture("gamelog/" + std::string(name) + ".rcg.gz").string(), ""}, {}});
    }
  }

  std::string expected;
  for (const std::size_t jobs : {1, 4}) {
    std::vector<MatchSummary> summaries;
    for (const ReadResult& result : read_results(inputs, jobs)) {
      EXPECT_TRUE(result.usable);
      EXPECT_TRUE(result.errors.empty());
      summaries.push_back(result.summary);
    }
    const std::string text = format_results(summaries, ResultsFormat::kJson);
    if (expected.empty()) expected = text;

    EXPECT_EQ(text, expected);
  }
}

}  // namespace
}  // namespace cls::analysis
