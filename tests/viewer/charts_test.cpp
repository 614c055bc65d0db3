// Charts: what they show, and what data cannot break.
#include "viewer/charts/charts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/viewer/markup.h"
#include "viewer/charts/drawing.h"
#include "viewer/charts/layout.h"

namespace cls::viewer {
namespace {

using testing::HasSubstr;
using tests::attributes_of;
using tests::count;
using tests::svg_error;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::string kMarkup = "</svg><script>alert(1)</script>\" onload=\"x\" & '\xff";

TimeAxis axis() { return {1000.0, {{0.0, "0"}, {500.0, "500"}, {1000.0, "1000"}}, {500.0}}; }

RaceData race() {
  RaceData data;
  data.title = {"Race", "note"};
  data.axis = axis();
  data.teams = {"RED", "BLUE"};
  data.steps[0] = {{100.0, 0.25, false, ""}, {400.0, 0.5, false, ""}, {402.0, 0.0, true, "1:0"}};
  data.steps[1] = {{700.0, 0.1, false, ""}};
  return data;
}

// The second numbers of "x,y x,y ...".
std::vector<double> heights_of(const std::string& svg, const std::string& kind) {
  const std::size_t end = svg.find("\" class=\"" + kind);
  const std::size_t start = svg.rfind("points=\"", end) + 8;
  std::vector<double> heights;
  std::string points = svg.substr(start, end - start);
  for (std::size_t comma = points.find(','); comma != std::string::npos;
       comma = points.find(',', comma + 1)) {
    heights.push_back(std::stod(points.substr(comma + 1)));
  }
  return heights;
}

TEST(Drawing, FormatsNumbersInOneWay) {
  EXPECT_EQ(svg_number(12.0), "12");
  EXPECT_EQ(svg_number(12.3456), "12.35");
  EXPECT_EQ(svg_number(100.0), "100");
  EXPECT_EQ(svg_number(-0.001), "0");
  EXPECT_EQ(svg_number(kNan), "0");
  EXPECT_EQ(svg_number(-kInfinity), "0");
}

TEST(Drawing, ShortensNamesByCharacters) {
  EXPECT_EQ(shortened_name("HELIOS", 6), "HELIOS");
  EXPECT_EQ(shortened_name("HELIOS2", 6), "HELIOS...");
  EXPECT_EQ(shortened_name("\xc3\xa4\xc3\xb6\xc3\xbc", 2), "\xc3\xa4\xc3\xb6...");
  EXPECT_EQ(shortened_name("\xff\xff\xff", 2), "\xff\xff...");
}

TEST(Drawing, IsAFileOfItsOwnWithItsStyle) {
  const std::string file = standalone_svg(race_chart(race()));
  EXPECT_EQ(count(file, "<style>"), 1U);
  EXPECT_THAT(file, HasSubstr("prefers-color-scheme:dark"));
  EXPECT_TRUE(file.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_EQ(svg_error(race_chart(race())), "");
}

TEST(Charts, DrawEmptyData) {
  const std::vector<std::string> charts = {
      heat_map({}),     pass_network_chart({}), shot_map({}),
      race_chart({}),   shares_chart({}),       scene_chart({}),
      search_chart({}), ratings_chart({}),      differences_chart({})};
  for (const std::string& chart : charts) EXPECT_EQ(svg_error(chart), "") << chart;
  EXPECT_THAT(charts[1], HasSubstr("no completed pass"));
}

TEST(Charts, ShowNamesAsText) {
  const ChartTitle title = {kMarkup, kMarkup};
  RaceData steps = race();
  steps.title = title;
  steps.teams = {kMarkup, kMarkup};
  steps.steps[0][2].tip = kMarkup;
  steps.axis.ticks[0].text = kMarkup;

  const std::array<std::string, 2> teams = {kMarkup, kMarkup};
  const std::vector<std::string> charts = {
      heat_map({title, Tone::kBoth, 5.0, 1, 1, {1.0}}),
      pass_network_chart({title, Tone::kLeft, {{7, {1.0, 2.0}, 3}}, {}}),
      shot_map({title, teams, {{0, {40.0, 0.0}, 0.3, true, kMarkup}}}),
      race_chart(steps),
      shares_chart({title, axis(), teams, {{kMarkup, {0.4, 0.6}}}}),
      scene_chart({title, teams, {{0, 7, {1.0, 2.0}, 90.0, true}}, {}, {}}),
      search_chart({title, kMarkup, 0.0, {{1, 0, 2}}, {{kMarkup, teams, {{0.5, 0.4, 0.6}}}}}),
      ratings_chart({title, {{kMarkup, 20.0, 10.0}}}),
      differences_chart({title, {1, -2}})};

  for (const std::string& chart : charts) {
    EXPECT_EQ(svg_error(chart), "") << chart;
    EXPECT_THAT(chart, HasSubstr("&lt;script&gt;")) << chart;
  }
}

TEST(Charts, LeaveOutWhatIsNotFinite) {
  RaceData steps = race();
  steps.steps[0].push_back({kNan, kNan, true, ""});
  steps.steps[1].push_back({800.0, kInfinity, false, ""});
  const std::vector<std::string> charts = {
      heat_map({{}, Tone::kBoth, 5.0, 2, 1, {kNan, 3.0}}),
      pass_network_chart({{}, Tone::kLeft, {{7, {kNan, 2.0}, 3}, {8, {}, 1}}, {{0, 1, 4}}}),
      shot_map({{}, {}, {{0, {kInfinity, 0.0}, 0.3, true, ""}, {1, {}, kNan, false, ""}}}),
      race_chart(steps),
      shares_chart({{}, axis(), {}, {{"x", {kNan, 0.5, kInfinity, 0.2, 0.9}}}}),
      scene_chart({{}, {}, {{0, 7, {kNan, 2.0}, kNan, true}}, {kNan, kNan}, {{kNan, 1.0}}}),
      search_chart({{}, "", 0.0, {{kNan, kNan, kInfinity}}, {{"x", {}, {{kNan, kNan, kNan}}}}}),
      ratings_chart({{}, {{"x", kNan, kNan}, {"y", 3.0, kInfinity}}})};
  for (const std::string& chart : charts) EXPECT_EQ(svg_error(chart), "") << chart;
}

TEST(Charts, GiveTheSameTextAgain) {
  EXPECT_EQ(race_chart(race()), race_chart(race()));
  const SceneData scene = {{"a", "b"}, {"c", "d"}, {{1, 11, {-3.25, 8.5}, 45.0, false}}, {}, {}};
  EXPECT_EQ(scene_chart(scene), scene_chart(scene));
}

TEST(RatingsChart, DrawsATeamWithItsInterval) {
  const std::string chart = ratings_chart({{}, {{"A", 100.0, 50.0}, {"B", -100.0, 100.0}}});
  const std::vector<double> dots = attributes_of(chart, "circle", "cx", "");
  const std::vector<double> starts = attributes_of(chart, "line", "x1", "left-line");
  const std::vector<double> ends = attributes_of(chart, "line", "x2", "left-line");
  ASSERT_EQ(dots.size(), 2U);
  ASSERT_EQ(starts.size(), 2U);
  EXPECT_NEAR(dots[0] - dots[1], 2 * (ends[1] - dots[1]), 0.05) << "200 Elo apart";
  EXPECT_NEAR(ends[0] - dots[0], (dots[1] - starts[1]) / 2, 0.05);
}

TEST(DifferencesChart, HasABarForEachDifference) {
  const std::string chart = differences_chart({{}, {3, 0, 3, -1, 3}});
  const std::vector<double> bars = attributes_of(chart, "rect", "height", "left\"");
  ASSERT_EQ(bars.size(), 1U);
  const std::vector<double> lost = attributes_of(chart, "rect", "height", "right\"");
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_NEAR(bars[0], 3 * lost[0], 0.05);
  EXPECT_THAT(chart, HasSubstr(">+3<"));
}

TEST(DifferencesChart, DrawsTheMeanFromTheFifthMatchOn) {
  std::vector<int> differences = {1, 1, 1, 1};
  EXPECT_EQ(count(differences_chart({{}, differences}), "<polyline"), 0U);
  differences.insert(differences.end(), {1, 6});
  const std::vector<double> heights = heights_of(differences_chart({{}, differences}), "left-line");
  ASSERT_EQ(heights.size(), 2U);
  EXPECT_LT(heights[1], heights[0]) << "up";
}

TEST(DifferencesChart, DrawsHugeDifferences) {
  const int huge = std::numeric_limits<int>::max();
  EXPECT_EQ(svg_error(differences_chart({{}, {huge, -huge, 0, 1, huge}})), "");
}

TEST(HeatMap, DrawsRareCellsFainter) {
  const std::string chart = heat_map({{}, Tone::kLeft, 5.0, 3, 1, {100.0, 1.0, 0.0}});
  const std::vector<double> opacities = attributes_of(chart, "path", "opacity", "\"left\"");
  ASSERT_EQ(opacities.size(), 2U) << "the cell without a count has no square";
  EXPECT_DOUBLE_EQ(opacities[1], 0.9);
  EXPECT_LT(opacities[0], 0.2);
}

TEST(HeatMap, DrawsNoCellsOfAnotherSize) {
  EXPECT_EQ(count(heat_map({{}, Tone::kLeft, 5.0, 3, 2, {1.0, 2.0}}), "class=\"left\""), 0U);
}

TEST(PassNetwork, ShowsFrequentPairsOnly) {
  PassNetworkData data;
  data.tone = Tone::kRight;
  data.nodes = {{1, {-30.0, 0.0}, 10}, {7, {0.0, 10.0}, 40}, {9, {20.0, 0.0}, 2}};
  data.edges = {{0, 1, 9}, {1, 2, 3}, {0, 2, 2}, {0, 9, 50}};
  const std::string chart = pass_network_chart(data);
  const std::vector<double> widths = attributes_of(chart, "line", "stroke-width", "\"right-line\"");
  ASSERT_EQ(widths.size(), 2U) << "the pair with two passes and the unknown one are left out";
  EXPECT_GT(widths[1], widths[0]);
  const std::vector<double> radii = attributes_of(chart, "circle", "r", "\"right\"");
  ASSERT_EQ(radii.size(), 3U);
  EXPECT_DOUBLE_EQ(radii[0] * 2, radii[1]) << "a quarter of the area";
  EXPECT_THAT(chart, HasSubstr("3 or more passes"));
}

TEST(PassNetwork, ShowsASinglePass) {
  const std::string chart =
      pass_network_chart({{}, Tone::kLeft, {{1, {}, 1}, {2, {5.0, 5.0}, 1}}, {{0, 1, 1}}});
  EXPECT_EQ(attributes_of(chart, "line", "stroke-width", "\"left-line\"").size(), 1U);
}

TEST(ShotMap, DrawsAreasByExpectedGoals) {
  const std::string chart = shot_map({{},
                                      {},
                                      {{0, {40.0, 0.0}, 0.4, false, ""},
                                       {0, {40.0, 9.0}, 0.1, false, ""},
                                       {1, {-40.0, 0.0}, 0.1, true, ""}}});
  std::vector<double> radii = attributes_of(chart, "circle", "r", "\"left\"");

  ASSERT_EQ(radii.size(), 3U) << "with the legend";

  std::ranges::sort(radii);
  EXPECT_NEAR(radii[2], 2 * radii[1], 0.01);
  EXPECT_EQ(attributes_of(chart, "circle", "opacity", "\"left\" opacity").size(), 2U);
  EXPECT_EQ(attributes_of(chart, "circle", "opacity", "\"right\" opacity").size(), 0U)
      << "goals are filled";

  const std::vector<double> x = attributes_of(chart, "circle", "cx", "\"right\"");
  EXPECT_LT(x.back(), 320.0) << "the right team shoots to the left";
}

TEST(TimeAxis, TextsAtTheEdgeEndThere) {
  Drawing drawing(kChartWidth, 100.0, "axis");
  const PlotPlace place{kChartMargin, kChartWidth - kChartMargin, 10.0, 60.0, 6000.0};
  draw_time_axis(drawing, place, {6000.0, {{3000.0, "3000"}, {6000.0, "6000"}}, {}});
  const std::string svg = std::move(drawing).finish();
  EXPECT_THAT(svg,
              HasSubstr("<text x=\"320\" y=\"77\" class=\"soft\" text-anchor=\"middle\">3000<"));
  EXPECT_THAT(svg, HasSubstr("<text x=\"628\" y=\"77\" class=\"soft\" text-anchor=\"end\">6000<"));
}

TEST(Race, RisesToTheSum) {
  const std::string chart = race_chart(race());
  const std::vector<double> heights = heights_of(chart, "left-line");
  ASSERT_EQ(heights.size(), 8U);
  EXPECT_TRUE(std::ranges::is_sorted(heights, std::greater()));
  EXPECT_GT(heights.front(), heights.back());
  EXPECT_THAT(chart, HasSubstr(">0.75<"));
  EXPECT_THAT(chart, HasSubstr(">0.1<"));
  EXPECT_THAT(chart, HasSubstr("<title>1:0</title>"));
}

TEST(Race, MovesEqualSumsApart) {
  RaceData data = race();
  data.steps[1] = data.steps[0];
  const std::string chart = race_chart(data);
  std::vector<double> y = attributes_of(chart, "text", "y", "class=\"left\"");
  const std::vector<double> right = attributes_of(chart, "text", "y", "class=\"right\"");
  ASSERT_EQ(y.size(), 1U);
  ASSERT_EQ(right.size(), 1U);
  EXPECT_GE(std::abs(y[0] - right[0]), 15.0);
}

TEST(Shares, LeavesGapsWhereNothingIsKnown) {
  const std::string whole = shares_chart({{}, axis(), {}, {{"x", {0.6, 0.6, 0.6, 0.6}}}});
  const std::string gap = shares_chart({{}, axis(), {}, {{"x", {0.6, kNan, kNan, 0.6}}}});
  EXPECT_EQ(count(whole, "<polygon"), 2U);
  EXPECT_EQ(count(gap, "<polygon"), 4U);
}

TEST(Shares, ChangesTeamsAtTheMiddle) {
  const std::string chart = shares_chart({{}, axis(), {}, {{"x", {1.0, 0.0}}}});
  // The left team's area ends where the share is one half: in the middle of the match.
  const std::size_t start = chart.find("<polygon points=\"") + 17;
  const std::string points = chart.substr(start, chart.find('"', start) - start);
  EXPECT_EQ(count(points, " "), 4U) << points;
  EXPECT_THAT(points, HasSubstr(" 332,")) << points;
}

TEST(Scene, PlacesPlayersAndBall) {
  const std::string chart =
      scene_chart({{},
                   {"L", "R"},
                   {{0, 7, {0.0, 0.0}, 0.0, false}, {1, 9, {30.0, 10.0}, 180.0, true}},
                   {30.0, 10.0},
                   {}});
  EXPECT_EQ(attributes_of(chart, "circle", "cx", "\"left\"").back(), 320.0);
  EXPECT_EQ(attributes_of(chart, "circle", "cx", "\"ball\"").back(),
            attributes_of(chart, "circle", "cx", "\"right\"").back());
  EXPECT_THAT(chart, HasSubstr(">7</text>"));
  EXPECT_THAT(chart, HasSubstr(">9</text>"));
}

}  // namespace
}  // namespace cls::viewer
