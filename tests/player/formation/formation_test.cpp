// Triangulation, interpolation, and all formation file formats.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "player/formation/formation_file.h"
#include "player/formation/formation_set.h"
#include "player/formation/triangulation.h"
#include "tests/support/temporary_folder.h"

namespace cls::player {
namespace {

using testing::HasSubstr;

std::vector<Vec2> scattered(int count) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    points.push_back({52.0 * std::sin(12.9 * i), 34.0 * std::sin(78.2 * i + 1.0)});
  }
  return points;
}

TEST(Triangulation, IsDelaunayAndCoversConvexHull) {
  const std::vector<Vec2> points = scattered(60);
  double area = 0.0;
  for (const Triangle& t : triangulate(points)) {
    const Vec2 a = points[t[0]];
    const Vec2 b = points[t[1]];
    const Vec2 c = points[t[2]];
    const double doubled = cross(b - a, c - a);
    ASSERT_GT(doubled, 0.0);
    area += doubled / 2.0;

    // Circumcenter by the perpendicular bisectors.
    const Vec2 u = b - a;
    const Vec2 v = c - a;
    const Vec2 center = a + Vec2{v.y * u.squared_length() - u.y * v.squared_length(),
                                 u.x * v.squared_length() - v.x * u.squared_length()} /
                                (2.0 * doubled);
    const double radius = distance(center, a);
    for (const Vec2 p : points) EXPECT_GE(distance(center, p), radius - 1e-6);
  }

  // Area of the convex hull by gift wrapping.
  const Vec2 start = *std::ranges::min_element(points, {}, &Vec2::x);
  double hull = 0.0;
  Vec2 at = start;
  do {
    Vec2 next = at == points[0] ? points[1] : points[0];
    for (const Vec2 point : points) {
      if (cross(next - at, point - at) < 0.0) next = point;
    }
    hull += cross(at, next) / 2.0;
    at = next;
  } while (!(at == start));
  EXPECT_NEAR(area, hull, 0.01 * hull);
}

TEST(Triangulation, IsEmptyForFewerThanThreeNonCollinearPoints) {
  EXPECT_TRUE(triangulate({{0, 0}, {1, 1}}).empty());
  EXPECT_TRUE(triangulate({{0, 0}, {1, 1}, {2, 2}}).empty());
  EXPECT_EQ(triangulate({{0, 0}, {1, 0}, {0, 1}}).size(), 1U);
}

/// A formation with every player at (2x + y, x - 3y) for ball (x, y): linear, so interpolation is
/// exact inside the samples.
Formation linear_formation(const std::vector<Vec2>& balls) {
  std::vector<FormationSample> samples;
  for (const Vec2 ball : balls) {
    FormationSample& sample = samples.emplace_back();
    sample.ball = ball;
    sample.players.fill({2.0 * ball.x + ball.y, ball.x - 3.0 * ball.y});
  }
  return *Formation::make(samples);
}

TEST(Formation, InterpolatesLinearlyBetweenSamples) {
  std::vector<Vec2> balls{{-54, -36}, {54, -36}, {54, 36}, {-54, 36}};
  for (const Vec2 p : scattered(30)) balls.push_back(p);
  const Formation formation = linear_formation(balls);
  for (const Vec2 ball : std::vector<Vec2>{{0, 0}, {12.3, -7.7}, {-50, 30}, {54, -36}, {5, 36}}) {
    const Vec2 place = formation.positions(ball)[4];
    EXPECT_NEAR(place.x, 2.0 * ball.x + ball.y, 1e-9);
    EXPECT_NEAR(place.y, ball.x - 3.0 * ball.y, 1e-9);
  }
}

TEST(Formation, UsesNearestHullPointForBallOutside) {
  const Formation square = linear_formation({{-10, -10}, {10, -10}, {10, 10}, {-10, 10}});
  EXPECT_NEAR(square.positions({30.0, 4.0})[0].x, 24.0, 1e-9);
  EXPECT_NEAR(square.positions({30.0, 40.0})[0].y, -20.0, 1e-9);
  const Formation line = linear_formation({{0, 0}, {10, 0}, {20, 0}});
  EXPECT_NEAR(line.positions({13.0, 25.0})[0].x, 26.0, 1e-9);
  const Formation point = linear_formation({{3, 3}});
  EXPECT_NEAR(point.positions({-40.0, 20.0})[0].x, 9.0, 1e-9);
}

TEST(Formation, RejectsNoSamplesAndDuplicateBallPositions) {
  EXPECT_FALSE(Formation::make({}));
  const FormationSample sample{{1.0, 2.0}, {}};
  const auto twice = Formation::make({sample, sample});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().message, "two samples with the ball at (1, 2)");
}

std::string own_sample(const std::string& ball) {
  std::string text = "ball " + ball + "\n";
  for (int n = 1; n <= 11; ++n) text += fmt::format("  {0} {0} {1}  # a comment\n", n, -2 * n);
  return text;
}

TEST(FormationFile, MirrorsSamplesAndSwapsPairs) {
  const auto formation = parse_formation(
      "cls-formation 1\n# comment\npair 2 3\nmirror\n\n" + own_sample("10 20") + own_sample("5 0"),
      "f");
  ASSERT_TRUE(formation) << formation.error().message;
  ASSERT_EQ(formation->samples().size(), 3U) << "the sample on the center line has no mirror image";
  const TeamPoints image = formation->positions({10.0, -20.0});
  EXPECT_EQ(image[1], (Vec2{3.0, 6.0})) << "2 at the mirrored position of 3";
  EXPECT_EQ(image[2], (Vec2{2.0, 4.0}));
  EXPECT_EQ(image[5], (Vec2{6.0, 12.0}));
}

TEST(FormationFile, RoundTripsToTheSameBits) {
  const Formation formation = linear_formation(scattered(12));
  const auto again = parse_formation(format_formation(formation), "again");
  ASSERT_TRUE(again);
  ASSERT_EQ(again->samples().size(), formation.samples().size());
  for (std::size_t i = 0; i < formation.samples().size(); ++i) {
    EXPECT_EQ(again->samples()[i].ball, formation.samples()[i].ball);
    EXPECT_EQ(again->samples()[i].players, formation.samples()[i].players);
  }
}

TEST(FormationFile, ReportsErrorsWithLine) {
  for (const auto& [text, error] : std::vector<std::pair<std::string, std::string>>{
           {"", "f: empty"},
           {"hello\n", "f:1: not a formation file"},
           {"cls-formation 7\n", "f:1: unsupported version; use cls-formation 1"},
           {"cls-formation 1\nball 1\n", "f:2: expected 'ball X Y'"},
           {"cls-formation 1\nball 1 nan\n", "f:2: expected 'ball X Y'"},
           {"cls-formation 1\n3 1 1\n", "f:2: player before the first 'ball X Y'"},
           {"cls-formation 1\nball 0 0\n1 1 1\n1 2 2\n", "f:4: duplicate player 1"},
           {"cls-formation 1\nball 0 0\n1 1 1\n", "f:3: missing player 2 in the sample"},
           {"cls-formation 1\npair 2 2\n", "f:2: expected 'pair UNUM UNUM'"},
           {"Formation UvA\n", "f: unknown method 'UvA'; supported: Static, DelaunayTriangulation"},
           {"{\"method\": \"Static\"}", "f: missing 'method' or 'data'"},
           {"{", "f: not valid JSON"},
           {"{\"method\": \"Static\", \"data\": [{\"ball\": {\"x\": 0, \"y\": 0}}]}",
            "f: data[0]: no player '1' with x and y"},
           {"Formation DelaunayTriangulation 3\nBegin Samples 2 1\nBall 1 2\n1 3 4\n",
            "f:4: the last sample is incomplete"}}) {
    const auto formation = parse_formation(text, "f");
    ASSERT_FALSE(formation) << text;
    EXPECT_EQ(formation.error().message, error);
  }
}

// The same two samples in each librcsc format; player n at (n, -n), then at (n + 0.5, 0).
std::string block_form(const std::string& head) {
  std::string text = head + "Begin Samples 2 2\n";
  text += "----- 0 -----\nBall 0 0\n";
  for (int n = 1; n <= 11; ++n) text += fmt::format("{0} {0} -{0}\n", n);
  text += "----- 1 -----\nBall 10 5\n";
  for (int n = 1; n <= 11; ++n) text += fmt::format("{0} {0}.5 0\n", n);
  return text + "End Samples\nEnd\n";
}

std::string row(bool second, const std::string& separator) {
  std::string text = second ? "10" + separator + "5" : "0" + separator + "0";
  for (int n = 1; n <= 11; ++n) {
    text += separator + (second ? fmt::format("{}.5{}0", n, separator)
                                : fmt::format("{0}{1}-{0}", n, separator));
  }
  return text;
}

std::string json_form() {
  std::string first;
  std::string second;
  for (int n = 1; n <= 11; ++n) {
    first += fmt::format(R"(, "{0}": {{"x": {0}, "y": -{0}}})", n);
    second += fmt::format(R"(, "{0}": {{"x": {0}.5, "y": 0}})", n);
  }
  return R"({"version": "", "method": "DelaunayTriangulation", "role": [], "data": [)"
         R"({"index": 0, "ball": {"x": 0.0, "y": 0})" +
         first + R"(}, {"index": 1, "ball": {"x": 10, "y": 5})" + second + "}]}\n";
}

TEST(FormationFile, ParsesLibrcscFormats) {
  const std::vector<std::string> forms{
      json_form(),
      block_form("# made by hand\nFormation DelaunayTriangulation 2\nBegin Roles\n1 Goalie 0\n"
                 "End Roles\n"),
      block_form("Formation DelaunayTriangulation 3\nBegin Roles\n1 G Goalie 0 x x\nEnd Roles\n"),
      "Formation DelaunayTriangulation\nGoalie 0 CenterBack -1\n" + row(false, " ") + " \n" +
          row(true, " ") + " \nEnd\n",
      "# CSV\nMethod,DelaunayTriangulation\nRoleNumber,1,2\nSampleData\nSize,2\nidx,ballX,ballY\n"
      "0," +
          row(false, ",") + "\n1," + row(true, ",") + "\n"};

  for (std::size_t i = 0; i < forms.size(); ++i) {
    const auto formation = parse_formation(forms[i], "form");
    ASSERT_TRUE(formation) << i << ": " << formation.error().message;
    ASSERT_EQ(formation->samples().size(), 2U) << i;
    EXPECT_EQ(formation->samples()[1].ball, (Vec2{10.0, 5.0})) << i;
    EXPECT_EQ(formation->samples()[0].players[6], (Vec2{7.0, -7.0})) << i;
    EXPECT_EQ(formation->samples()[1].players[10], (Vec2{11.5, 0.0})) << i;
  }
}

TEST(FormationFile, ParsesStaticLibrcscFormats) {
  std::string text = "Formation Static\n# ----\n";
  std::string csv = "Method,Static\nRoleNumber,1,2\nPosition";
  for (int n = 1; n <= 11; ++n) {
    text += fmt::format("{0} Role  -{0}.0   {0}\n", n);
    csv += fmt::format(",-{0},{0}", n);
  }

  for (const std::string& form : {text, csv + "\n"}) {
    const auto formation = parse_formation(form, "static");
    ASSERT_TRUE(formation) << formation.error().message;
    EXPECT_EQ(formation->positions({30.0, -20.0})[8], (Vec2{-9.0, 9.0}));
  }
}

TEST(FormationSet, BuiltInFormationsKeepAllPlayersOnPitch) {
  const auto set = built_in_formations();
  for (std::size_t kind = 0; kind < kFormationKindCount; ++kind) {
    const Formation& formation = set->of(static_cast<FormationKind>(kind));
    for (double x = -56.0; x <= 56.0; x += 7.0) {
      for (double y = -38.0; y <= 38.0; y += 7.6) {
        const TeamPoints points = formation.positions({x, y});

        for (std::size_t i = 0; i < points.size(); ++i) {
          EXPECT_LE(std::fabs(points[i].x), 52.5) << kind << " " << i;
          EXPECT_LE(std::fabs(points[i].y), 34.0) << kind << " " << i;
          for (std::size_t other = i + 1; other < points.size(); ++other) {
            EXPECT_GT(distance(points[i], points[other]), 0.8) << kind << " ball " << x << " " << y;
          }
        }
      }
    }
  }

  for (const Vec2 point : set->of(FormationKind::kBeforeKickOff).positions({})) {
    EXPECT_LE(point.x, 0.0);
  }
}

TEST(LibrcscFormation, RefusesLinesOfCommasAlone) {
  for (const char* text :
       {"l,\n", ",,\n", "Method,Static\n,,,\n", "Method,DelaunayTriangulation\n,"}) {
    const auto read = parse_librcsc_formation(text, "form.csv");
    EXPECT_TRUE(!read || read->empty()) << text;
  }
}

TEST(FormationSet, ReadsFolderInBothFormatsAndReportsMissingFile) {
  const tests::TemporaryFolder folder;
  for (std::size_t kind = 0; kind < kFormationKindCount; ++kind) {
    const std::string name(file_name(static_cast<FormationKind>(kind)));
    const bool own = kind % 2 == 0;
    std::ofstream(folder.path() / (name + (own ? ".formation" : ".conf")))
        << (own ? "cls-formation 1\n" + own_sample("0 0") : json_form());
  }

  const auto set = read_formations(folder.path().string());
  ASSERT_TRUE(set) << set.error().message;
  EXPECT_EQ((*set)->of(FormationKind::kNormal).samples().size(), 2U);
  EXPECT_EQ((*set)->of(FormationKind::kBeforeKickOff).samples().size(), 1U);

  std::filesystem::remove(folder.path() / "goal-kick-our.formation");
  const auto missing = read_formations(folder.path().string());
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("goal-kick-our"));
}

}  // namespace
}  // namespace cls::player
