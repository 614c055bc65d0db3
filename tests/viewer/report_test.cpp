// Reports of real logs: their charts, tables and texts.
#include "viewer/report/report_documents.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "gamelog/rcg/rcg_reader.h"
#include "tests/gamelog/recorded_match.h"
#include "tests/support/files.h"
#include "tests/viewer/markup.h"
#include "tests/viewer/record_difference.h"
#include "viewer/charts/drawing.h"
#include "viewer/page/match_page.h"
#include "viewer/page/page.h"
#include "viewer/report/match_series.h"

namespace cls::viewer {
namespace {

using testing::HasSubstr;
using testing::Not;
using tests::count;
using tests::record_of;

/// A match with its report; the statistics refer to the record.
struct Match {
  explicit Match(gamelog::MatchRecord given) : record(std::move(given)) {
    report.summary = analysis::summarize(record, nullptr);
    report.summary.file = "game.rcg";
    report.statistics = &statistics;
  }

  gamelog::MatchRecord record;
  analysis::MatchStatistics statistics = analysis::compute_statistics(record, nullptr);
  MatchReport report;
};

std::vector<Chart> charts_of(const Match& match) {
  return match_charts(match.report.summary, match.statistics);
}

void rename_teams(gamelog::MatchRecord& record, const std::string& name) {
  for (auto& [left, right] : record.teams) left.name = right.name = name;
}

TEST(MatchReport, HasTheScoreAtHalfTimeOnlyOfMatchesThatReachedIt) {
  gamelog::MatchRecord record = record_of("match-start");
  EXPECT_THAT(report_markdown(Match(record).report, {}, ""), Not(HasSubstr("half time")));
  record.time.back() = static_cast<int>(analysis::half_time_cycles(record.server)) + 1;
  EXPECT_THAT(report_markdown(Match(record).report, {}, ""),
              HasSubstr("3001 cycles, half time 1:0"));
}

TEST(MatchCharts, DrawLogsOfAllVersions) {
  for (const char* fixture :
       {"rcg-v1-excerpt", "rcg-v2-excerpt", "rcg-v3-excerpt", "rcg-v4-excerpt", "rcg-v5-excerpt",
        "rcg-v6-excerpt", "rcg-json-excerpt", "match-start", "recorded-messages-excerpt"}) {
    SCOPED_TRACE(fixture);
    const Match match(record_of(fixture));
    const std::vector<Chart> charts = charts_of(match);
    ASSERT_GE(charts.size(), 8U);
    EXPECT_EQ(charts.size(), 8U + match.statistics.goals.size());
    for (const Chart& chart : charts) EXPECT_EQ(tests::svg_error(chart.svg), "") << chart.name;
  }
}

TEST(MatchCharts, DrawNothingWithoutFrames) { EXPECT_TRUE(charts_of(Match({})).empty()); }

TEST(MatchCharts, DrawAMatchOfOnePlayer) {
  gamelog::MatchRecord record = record_of("match-start");
  for (std::size_t entry = 0; entry < record.players.state.size(); ++entry) {
    if (entry % gamelog::kSlots != 8) record.players.state[entry] = 0;
  }
  for (const Chart& chart : charts_of(Match(std::move(record)))) {
    EXPECT_EQ(tests::svg_error(chart.svg), "") << chart.name;
  }
}

TEST(MatchCharts, ShowTheSumsOfTheStatistics) {
  const auto path = tests::data("logs/helios-vs-helios-full.rcg.gz");
  if (!path) GTEST_SKIP() << "no data: set CLS_DATA";
  const Match match(gamelog::read_rcg_file(path->string()).value());
  const std::vector<Chart> charts = charts_of(match);
  double expected = 0.0;
  for (std::size_t i = 0; i < match.statistics.shots.size(); ++i) {
    if (match.statistics.shots[i].slot < 11) expected += match.statistics.expected[i];
  }
  ASSERT_GT(expected, 0.0);
  EXPECT_THAT(charts[0].svg, HasSubstr(">" + svg_number(expected) + "</text>"));
  EXPECT_EQ(count(charts[2].svg, "<title>"), match.statistics.shots.size());
  EXPECT_EQ(charts.size(), 8U + match.statistics.goals.size());
}

TEST(MatchSeries, FollowsPossession) {
  Match match(record_of("match-start"));
  const std::vector<double> shares = possession_over_time(match.statistics);
  ASSERT_EQ(shares.size(), 121U);
  int known = 0;
  for (const double share : shares) {
    known += std::isfinite(share);
    EXPECT_TRUE(!std::isfinite(share) || (share >= 0.0 && share <= 1.0)) << share;
  }
  EXPECT_GT(known, 60);
}

TEST(MatchSeries, CountsTheFramesOfAnOwner) {
  gamelog::MatchRecord record = record_of("match-start");
  analysis::MatchStatistics all = analysis::compute_statistics(record, nullptr);
  for (std::size_t i = 0; i < record.frames(); ++i) {
    all.flow.phase[i] = analysis::Phase::kLive;
    all.flow.owner[i] = i < record.frames() / 2 ? 3 : 15;
  }
  const std::vector<double> shares = possession_over_time(all);
  EXPECT_EQ(shares.front(), 1.0);
  EXPECT_EQ(shares.back(), 0.0);
  EXPECT_NEAR(shares[60], 0.5, 0.02);
}

TEST(MatchSeries, HasTicksInTheOrderOfTheLog) {
  const TimeAxis axis = time_axis(record_of("match-start"));
  ASSERT_GE(axis.ticks.size(), 2U);
  EXPECT_LE(axis.ticks.size(), 12U);
  for (std::size_t i = 1; i < axis.ticks.size(); ++i) {
    EXPECT_GT(axis.ticks[i].at, axis.ticks[i - 1].at);
    EXPECT_GT(std::stoi(axis.ticks[i].text), std::stoi(axis.ticks[i - 1].text));
  }
}

TEST(MatchSeries, DividesNormalTimeOnly) {
  gamelog::MatchRecord record = record_of("match-start");
  const double half = analysis::half_time_cycles(record.server);
  ASSERT_GT(half, static_cast<double>(record.time[record.frames() - 1]));
  EXPECT_TRUE(time_axis(record).halves.empty());
  for (std::size_t i = 0; i < record.frames(); ++i) {
    record.time[i] = static_cast<int>(half * 5.0 * static_cast<double>(i) /
                                      static_cast<double>(record.frames() - 1));
  }
  const TimeAxis axis = time_axis(record);
  ASSERT_EQ(axis.halves.size(), 2U);
  EXPECT_NEAR(axis.halves[0], axis.last / 5, 2.0);
  EXPECT_NEAR(axis.halves[1], axis.last * 2 / 5, 2.0);
}

TEST(MatchReport, IsALogWithAReplay) {
  const Match match(record_of("rcg-v6-excerpt"));
  const std::string page = match_page(match.record, nullptr, "game.rcg");
  const std::string html = report_html(match.report, charts_of(match), page);
  EXPECT_TRUE(looks_like_page(html));
  EXPECT_EQ(tests::record_difference(match.record, read_page(html)), "");
  EXPECT_THAT(html, Not(HasSubstr("unsafe-")));
}

TEST(MatchReport, HasNoScriptWithoutAReplay) {
  Match match(record_of("match-start"));
  const std::string html = report_html(match.report, charts_of(match), "");
  EXPECT_EQ(count(html, "<script"), 0U);
  EXPECT_EQ(count(html, "script-src"), 0U);
  EXPECT_EQ(count(html, "<svg"), charts_of(match).size());
  EXPECT_EQ(count(html, " style="), 0U);
  EXPECT_EQ(count(html, "http"), charts_of(match).size() + 1) << "namespaces and http-equiv only";
}

TEST(MatchReport, ShowsNamesAsText) {
  for (const std::string name :
       {"</script><script>alert(1)</script>", "\"'><img src=x>", "</style><b>", "\xff\xfe\x01",
        "<script type=\"application/cls-view;base64\" id=\"match\" data-length=\"4\">AAAA"}) {
    SCOPED_TRACE(name);
    gamelog::MatchRecord record = record_of("match-start");
    rename_teams(record, name);
    Match match(std::move(record));
    match.report.playmakers = {{name, name, 10, 1, 2, 1.0, 2.0, 3.0, 4.0}};
    match.report.warnings = {name};
    match.report.command = name;
    const std::string page = match_page(match.record, nullptr, "game.rcg");
    const std::string html = report_html(match.report, charts_of(match), page);

    EXPECT_EQ(count(html, "<script"), 3U) << "those of the replay";
    EXPECT_EQ(count(html, "<img"), 0U);
    EXPECT_EQ(count(html, "</style"), 3U);
    EXPECT_TRUE(read_page(html));
  }
}

TEST(MatchReport, HasLatenciesOfPlaymakers) {
  Match match(record_of("match-start"));
  EXPECT_THAT(report_html(match.report, {}, ""), Not(HasSubstr("Playmaker")));
  match.report.playmakers = {{"RED", "mock", 72479, 3, 4, 110.4, 210.0, 310.0, 4100.0}};
  for (const std::string& text :
       {report_html(match.report, {}, ""), report_markdown(match.report, {}, "")}) {
    EXPECT_THAT(text, HasSubstr("72479"));
    EXPECT_THAT(text, HasSubstr("110 us"));
    EXPECT_THAT(text, HasSubstr("4100 us"));
  }
}

TEST(MatchReport, IsMarkdownWithImages) {
  gamelog::MatchRecord record = record_of("match-start");
  rename_teams(record, "a|*b*<img>");
  Match match(std::move(record));
  const std::string text = report_markdown(match.report, charts_of(match), "report-charts");
  EXPECT_TRUE(text.starts_with("# a\\|\\*b\\*\\<img> 1:0 ")) << text.substr(0, 60);
  EXPECT_EQ(count(text, "](report-charts/"), charts_of(match).size());
  EXPECT_THAT(text, HasSubstr("\n| possession (last touch) |"));
  EXPECT_THAT(report_markdown(match.report, charts_of(match), ""), Not(HasSubstr("svg")));
}

}  // namespace
}  // namespace cls::viewer
