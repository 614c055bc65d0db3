// The search of `cls tune`: optimizers on functions with a known optimum, parameters, races, files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include "base/text/json.h"
#include "soccer/random.h"
#include "tests/tournament/fake_executor.h"
#include "tournament/tuning/candidate.h"
#include "tournament/tuning/optimizer.h"
#include "tournament/tuning/race.h"
#include "tournament/tuning/symmetric_matrix.h"
#include "tournament/tuning/tune_config.h"
#include "tournament/tuning/tune_report.h"
#include "tournament/tuning/tuning.h"

namespace cls::tournament {
namespace {

using testing::HasSubstr;

SearchSpace cube(std::size_t dimensions, double start, double step) {
  SearchSpace space;
  space.start = Point(dimensions, start);
  space.steps = Point(dimensions, step);
  space.min_steps = Point(dimensions, 0.0);
  return space;
}

/// The largest error of a coordinate after `generations`, where `value` has its maximum at
/// `optimum` in each coordinate.
double error_after(Optimizer& optimizer, int generations, double optimum,
                   const std::function<double(const Point&)>& value) {
  for (int i = 0; i < generations; ++i) {
    std::vector<double> values;
    for (const Point& point : optimizer.ask()) values.push_back(value(point));
    optimizer.tell(values);
  }
  double error = 0.0;
  for (const double one : optimizer.best()) error = std::max(error, std::abs(one - optimum));
  return error;
}

double sphere(const Point& point) {
  double sum = 0.0;
  for (const double one : point) sum += (one - 0.6) * (one - 0.6);
  return 1 - sum / static_cast<double>(point.size());
}

// A long narrow valley along a curve, from (0, 0) scaled to its minimum at 0.6.
double rosenbrock(const Point& point) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < point.size(); ++i) {
    const double x = 1 + 4 * (point[i] - 0.6);
    const double y = 1 + 4 * (point[i + 1] - 0.6);
    sum += 100 * (y - x * x) * (y - x * x) + (1 - x) * (1 - x);
  }
  return -sum;
}

// Axes of a rotated ellipsoid with lengths 1 to 1000.
double ellipsoid(const Point& point) {
  const auto n = static_cast<double>(point.size());
  double sum = 0.0;
  const double mean = std::accumulate(point.begin(), point.end(), 0.0) / n;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const double along = point[i] - 0.6 + 2 * (mean - 0.6);
    sum += std::pow(1000.0, static_cast<double>(i) / std::max(1.0, n - 1)) * along * along;
  }
  return -sum;
}

TEST(CmaEs, FindsTheOptimumOfKnownFunctions) {
  for (const std::size_t n : {1u, 2u, 5u, 10u}) {
    EXPECT_LT(error_after(*make_cma_es(cube(n, 0.1, 0.2), 0, 1), 150, 0.6, sphere), 0.01) << n;
    EXPECT_LT(error_after(*make_cma_es(cube(n, 0.1, 0.2), 0, 2), 600, 0.6, ellipsoid), 0.01) << n;
  }
  EXPECT_LT(error_after(*make_cma_es(cube(2, 0.3, 0.1), 0, 3), 300, 0.6, rosenbrock), 0.01);
  EXPECT_LT(error_after(*make_cma_es(cube(4, 0.5, 0.05), 0, 3), 800, 0.6, rosenbrock), 0.02);
}

TEST(Spsa, FindsTheOptimumOfKnownFunctions) {
  for (const std::size_t n : {1u, 2u, 5u}) {
    EXPECT_LT(error_after(*make_spsa(cube(n, 0.1, 0.2), 800, 1), 800, 0.6, sphere), 0.03) << n;
  }
}

// Each value has noise as large as the difference between start and optimum.
TEST(Optimizers, ApproachTheOptimumThroughNoise) {
  double cma = 0.0;
  double spsa = 0.0;
  constexpr int kRuns = 10;
  for (int run = 1; run <= kRuns; ++run) {
    soccer::RandomStream noise(static_cast<std::uint64_t>(run), "noise");
    const auto noisy = [&](const Point& point) { return sphere(point) + noise.normal(0, 0.2); };
    const auto seed = static_cast<std::uint64_t>(run);
    cma += error_after(*make_cma_es(cube(2, 0.15, 0.2), 16, seed), 60, 0.6, noisy) / kRuns;
    spsa += error_after(*make_spsa(cube(2, 0.15, 0.2), 500, seed), 500, 0.6, noisy) / kRuns;
  }

  EXPECT_LT(cma, 0.25) << "0.45 at the start";
  EXPECT_LT(spsa, 0.2);
}

TEST(Optimizers, StayInsideTheCubeAndTheConstraints) {
  for (const bool cma : {true, false}) {
    SearchSpace space = cube(3, 0.3, 0.3);
    space.valid = [](const Point& point) { return point[0] + point[1] <= 0.8; };

    auto optimizer = cma ? make_cma_es(space, 0, 5) : make_spsa(space, 100, 5);
    for (int i = 0; i < 100; ++i) {
      std::vector<double> values;
      for (const Point& point : optimizer->ask()) {
        EXPECT_TRUE(space.valid(point));
        for (const double one : point) {
          EXPECT_GE(one, 0.0);
          EXPECT_LE(one, 1.0);
        }
        values.push_back(point[0] + point[1] + point[2]);  // pulls out of bounds
      }
      optimizer->tell(values);
    }

    EXPECT_TRUE(space.valid(optimizer->best()));
    EXPECT_GT(optimizer->best()[2], 0.9) << cma;
    EXPECT_GT(optimizer->best()[0] + optimizer->best()[1], 0.7) << cma;
  }
}

TEST(Optimizers, RepeatTheSameSearch) {
  const auto trace = [](std::uint64_t seed) {
    auto optimizer = make_cma_es(cube(3, 0.4, 0.2), 0, seed);
    error_after(*optimizer, 5, 0.6, sphere);
    return optimizer->ask();
  };
  EXPECT_EQ(trace(1), trace(1));
  EXPECT_NE(trace(1), trace(2));
}

TEST(SymmetricMatrix, DecomposesIntoOrthogonalAxes) {
  soccer::RandomStream random(1, "matrix");
  constexpr std::size_t kSize = 6;
  std::array<std::array<double, kSize>, kSize> root{};

  for (auto& row : root) {
    for (double& one : row) one = random.normal(0, 1);
  }

  SymmetricMatrix matrix(kSize);
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0.0;
      for (std::size_t k = 0; k < kSize; ++k) sum += root[i][k] * root[j][k];
      matrix.set(i, j, sum);
    }
  }

  const EigenDecomposition axes = eigen_decomposition(matrix);
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t j = 0; j < kSize; ++j) {
      double restored = 0.0;
      double product = 0.0;
      for (std::size_t k = 0; k < kSize; ++k) {
        restored += axes.vectors(i, k) * axes.roots[k] * axes.roots[k] * axes.vectors(j, k);
        product += axes.vectors(k, i) * axes.vectors(k, j);
      }
      EXPECT_NEAR(restored, matrix(i, j), 1e-9);
      EXPECT_NEAR(product, i == j ? 1.0 : 0.0, 1e-9);
    }
  }
}

Parameter parameter(const std::string& name, double min, double max, double start) {
  Parameter one;
  one.name = name;
  one.min = min;
  one.max = max;
  one.start = start;
  one.step = 0.2;
  return one;
}

TEST(Parameter, MapsScalesAndIntegers) {
  const Parameter linear = parameter("a", -2, 2, 1);
  EXPECT_EQ(value_at(linear, 0.75), 1.0);
  EXPECT_EQ(value_at(linear, 1.5), 2.0) << "clamped";

  Parameter log = parameter("b", 0.001, 10, 0.1);
  log.scale = Scale::kLog;
  EXPECT_NEAR(value_at(log, 0.5), 0.1, 1e-12);
  EXPECT_EQ(value_text(log, 0.1), "0.1");

  Parameter whole = parameter("c", 1, 4, 2);
  whole.integer = true;
  std::map<double, int> counts;
  for (int i = 0; i < 400; ++i) ++counts[value_at(whole, (i + 0.5) / 400)];

  EXPECT_EQ(counts, (std::map<double, int>{{1, 100}, {2, 100}, {3, 100}, {4, 100}}));

  for (const Parameter& one : {linear, log, whole}) {
    for (const double value : {one.min, one.start, one.max}) {
      EXPECT_NEAR(value_at(one, coordinate_of(one, value)), value, 1e-9) << one.name;
    }
  }

  EXPECT_EQ(value_text(whole, 3), "3");
}

TEST(Constraint, ReadsLinearExpressions) {
  const std::vector<Parameter> parameters = {parameter("near", 0, 10, 2),
                                             parameter("far", 0, 10, 4)};
  const auto holds = [&](const char* text, const Values& values) {
    const auto constraint = parse_constraint(text, parameters);
    EXPECT_TRUE(constraint) << text;
    return constraint && satisfies(values, {*constraint});
  };

  EXPECT_TRUE(holds("near < far", {2, 4}));
  EXPECT_FALSE(holds("near < far", {5, 4}));
  EXPECT_TRUE(holds("near + 2 * far <= 10", {2, 4}));
  EXPECT_FALSE(holds("near + 2 * far <= 10", {3, 4}));
  EXPECT_TRUE(holds("far - near >= 1.5", {2, 4}));
  EXPECT_FALSE(holds("far - near >= 1.5", {3, 4}));
  EXPECT_TRUE(holds("-near >= -3", {3, 0}));

  const auto error = [&](const char* text) {
    return parse_constraint(text, parameters).error().message;
  };
  EXPECT_EQ(error("neer < far"), "no parameter 'neer'; did you mean 'near'?");
  EXPECT_EQ(error("near far"), "expected <= or >=");
  EXPECT_EQ(error("near <"), "expected a number or the name of a parameter");
  EXPECT_EQ(error("near < far < 3"), "unexpected '< 3'");
}

constexpr const char* kFile = R"(
[tune]
team = "run:./run --port {port} --press {press}"
opponents = ["mock", "OLD"]
method = "cma-es"
measure = "points"
pairs = 4
constraints = ["press <= width"]
environment = { WIDTH = "{width}" }

[parameters.press]
min = 0
max = 1
start = 0.5

[parameters.width]
min = 1
max = 20
start = 4
integer = true
)";

TEST(TuneConfig, ReadsItsFile) {
  const ParsedTuneConfig parsed = parse_tune_config(kFile, "tune.toml");
  ASSERT_EQ(parsed.errors, std::vector<std::string>());
  const TuneConfig& config = parsed.config;
  ASSERT_EQ(config.parameters.size(), 2u);
  EXPECT_EQ(config.parameters[0].name, "press") << "in the order of the file";
  EXPECT_TRUE(config.parameters[1].integer);
  EXPECT_EQ(config.measure, Measure::kPoints);
  EXPECT_EQ(side_of(config, {0.25, 7}, ""), "run:export WIDTH=7; ./run --port {port} --press 0.25");
}

TEST(TuneConfig, NamesLineAndRemedyOfErrors) {
  const auto errors = [](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return parse_tune_config(text, "tune.toml").errors;
  };

  using Lines = std::vector<std::string>;

  EXPECT_EQ(errors(kFile, "pairs = 4", "pais = 4"),
            Lines{"tune.toml:7: unknown key 'pais'; did you mean 'pairs'?"});
  EXPECT_EQ(errors(kFile, "pairs = 4", "pairs = 0"),
            Lines{"tune.toml:7: pairs: must be a whole number from 1 to 10000"});
  EXPECT_EQ(errors(kFile, "\"cma-es\"", "\"sgd\""),
            Lines{"tune.toml:5: method: must be cma-es or spsa"});
  EXPECT_EQ(errors(kFile, "start = 0.5", "start = 2"),
            Lines{"tune.toml:11: press: start must be from min to max"});
  EXPECT_EQ(
      errors(kFile, "--press {press}", ""),
      Lines{"tune.toml:2: team: does not use {press}; name it in team, environment or a file"});
  EXPECT_EQ(errors(kFile, "press <= width", "press >= width"),
            Lines{"tune.toml:2: constraints: 'press >= width': the start values violate it"});
  EXPECT_EQ(parse_tune_config("", "tune.toml").errors.size(), 2u);
  EXPECT_EQ(parse_tune_config("schema = 2\npais = 4\n", "tune.toml").errors,
            Lines{"tune.toml:1: schema 2 is newer than this cls reads (1); update cls"});
  EXPECT_EQ(parse_tune_config("schema = 'x'\n", "tune.toml").errors,
            Lines{"tune.toml:1: schema: must be a whole number from 1 to 1"});
}

TEST(TuneConfig, WritesAnExampleThatParses) {
  EXPECT_EQ(parse_tune_config(commented_tune_config(), "tune.toml").errors,
            std::vector<std::string>());
}

TEST(Candidate, WritesFilesOfValues) {
  TuneConfig config;
  config.parameters = {parameter("shoot.distance", 0, 40, 20), parameter("shoot.power", 0, 1, 0.5)};
  config.file = "p.json";
  EXPECT_EQ(base::Json::parse(file_text(config, {12.5, 1})),
            base::Json::parse(R"({"shoot": {"distance": 12.5, "power": 1}})"));
  config.file = "p.toml";
  EXPECT_EQ(file_text(config, {12.5, 1}), "shoot.distance = 12.5\nshoot.power = 1\n");
  config.file_template = R"({"x": {shoot.distance}, "other": {"y": {z}}})";
  EXPECT_EQ(file_text(config, {12.5, 1}), R"({"x": 12.5, "other": {"y": {z}}})");
}

/// A search whose matches a function decides.
class FakeTuning {
 public:
  explicit FakeTuning(TuneConfig config) : tuning(std::move(config)) {}

  /// `goals` of a candidate against every opponent.
  void play(int generations, const std::function<int(const Values&, const Fixture&)>& goals) {
    for (int i = 0; i < generations; ++i) {
      const Race race = tuning.race();
      std::vector<ScheduledMatch> matches;
      while (true) {
        const auto round = next_round(tuning.config(), race, matches);
        if (round.empty()) break;
        for (const Fixture& fixture : round) {
          matches.push_back(planned(fixture));
          matches.back().outcome = outcome_of(fixture, goals);
        }
      }
      tuning.record(race_results(tuning.config(), race, matches));
      last = matches;
    }
  }

  Tuning tuning;
  std::vector<ScheduledMatch> last;  ///< of the last generation

 private:
  Outcome outcome_of(const Fixture& fixture,
                     const std::function<int(const Values&, const Fixture&)>& goals) const {
    const auto& candidates = tuning.candidates();
    const auto of = [&](int team) {
      const auto index = base::index(team);
      return index < candidates.size() ? goals(candidates[index], fixture) : 1;
    };
    return score(of(fixture.left), of(fixture.right));
  }
};

TuneConfig shooting() {
  TuneConfig config;
  config.team = "mock";
  config.opponents = {"mock:hold"};
  config.parameters = {parameter("y", -34, 34, 20), parameter("speed", 0.5, 3, 1)};
  config.pairs = 4;
  return config;
}

// More goals the nearer to the middle and the faster, with luck from the seed.
int goals_of(const Values& values, const Fixture& fixture) {
  soccer::RandomStream luck(fixture.seed, "luck", static_cast<std::uint64_t>(fixture.index));
  const double expected = 3 - std::abs(values[0]) / 10 + values[1] / 2;
  return std::max(0, static_cast<int>(std::lround(expected + luck.normal(0, 0.7))));
}

TEST(Tuning, FindsGoodValuesOfNoisyMatches) {
  FakeTuning cma(shooting());
  cma.play(15, goals_of);
  EXPECT_LT(std::abs(cma.tuning.best()[0]), 10) << "20 at the start";
  TuneConfig config = shooting();
  config.method = TuneMethod::kSpsa;
  config.generations = 60;
  FakeTuning spsa(config);
  spsa.play(60, goals_of);
  EXPECT_LT(std::abs(spsa.tuning.best()[0]), 10);
  EXPECT_GT(cma.tuning.history().back().score.score, cma.tuning.history().front().score.score);
}

TEST(Tuning, CandidatesPlayEachOtherWithoutOpponents) {
  TuneConfig config = shooting();
  config.opponents.clear();
  config.method = TuneMethod::kSpsa;
  config.generations = 60;
  FakeTuning direct(config);
  direct.play(60, goals_of);
  EXPECT_LT(std::abs(direct.tuning.best()[0]), 10);
  EXPECT_EQ(direct.tuning.pairs_played(), 60 * config.pairs);
  EXPECT_EQ(direct.last.size(), 2u * base::index(config.pairs));
}

TEST(Race, AllCandidatesPlayTheSameSeedsInTurn) {
  TuneConfig config = shooting();
  config.opponents = {"mock:hold", "mock"};
  const Race race{3, 4, 2};
  const auto fixtures = next_round(config, race, {});

  ASSERT_EQ(fixtures.size(), 8u);

  for (const Fixture& fixture : fixtures) {
    EXPECT_EQ(fixture.seed, fixtures[0].seed);
    EXPECT_EQ(std::max(fixture.left, fixture.right), 4) << "the first opponent";
  }
  std::vector<ScheduledMatch> matches;
  for (const Fixture& fixture : fixtures) {
    matches.push_back(planned(fixture));
    matches.back().outcome = score(1, 1);
  }
  const auto second = next_round(config, race, matches);

  ASSERT_EQ(second.size(), 8u);
  EXPECT_EQ(second[0].index, 9);
  EXPECT_NE(second[0].seed, fixtures[0].seed);
  EXPECT_EQ(std::max(second[0].left, second[0].right), 5) << "opponents take turns";
  EXPECT_NE(next_round(config, {4, 4, 2}, {})[0].seed, fixtures[0].seed);
}

// Candidate 0 always loses 0:3, the others win: it stops, and ranks last.
TEST(Race, StopsWorseCandidatesEarly) {
  TuneConfig config = shooting();
  config.pairs = 20;
  FakeTuning fake(config);
  int calls = 0;
  fake.play(1, [&](const Values& values, const Fixture&) {
    ++calls;
    return values == fake.tuning.candidates()[0] ? 0 : 4;
  });
  const auto& results = fake.tuning.history()[0].results;

  EXPECT_TRUE(results[0].stopped);
  EXPECT_LT(results[0].pairs.size(), 8u);

  for (std::size_t i = 1; i < results.size(); ++i) {
    EXPECT_FALSE(results[i].stopped);
    EXPECT_EQ(results[i].pairs.size(), 20u);
  }
  const auto values = ranking_values(config, results);

  EXPECT_EQ(std::min_element(values.begin(), values.end()), values.begin());
}

TEST(Race, EqualCandidatesRarelyStop) {
  TuneConfig config = shooting();
  config.pairs = 20;
  FakeTuning fake(config);
  fake.play(40, [](const Values&, const Fixture& fixture) {
    soccer::RandomStream luck(fixture.seed, "luck", static_cast<std::uint64_t>(fixture.index));
    return luck.integer(4);
  });
  int stopped = 0;
  int all = 0;
  for (const Generation& generation : fake.tuning.history()) {
    for (const RaceResult& result : generation.results) {
      stopped += result.stopped;
      ++all;
    }
  }

  EXPECT_LE(stopped, all / 10) << "the error probability of stop";
}

TEST(TuneReport, ShowsTableDiffAndPicture) {
  FakeTuning fake(shooting());
  fake.play(3, goals_of);
  const std::string text =
      tune_text(fake.tuning, TuneVerdict{"verdict: undecided\n", "undecided"}, 80);

  EXPECT_THAT(text, HasSubstr("-y = 20\n+y = "));
  EXPECT_THAT(text, HasSubstr("verdict: undecided"));

  const auto document = base::Json::parse(tune_json(fake.tuning, {}));
  EXPECT_EQ(document["schema"], "cls.tune/1");
  EXPECT_EQ(document["history"].size(), 3u);
  EXPECT_EQ(document["start"]["y"], 20);
  EXPECT_TRUE(document["verdict"].is_null());

  const std::string picture = tune_picture(fake.tuning);
  EXPECT_EQ(picture.rfind("<svg ", 0), 0u);
  EXPECT_THAT(picture, HasSubstr(">speed<"));
  EXPECT_EQ(values_diff(fake.tuning.config(), {1, 2}, {1, 3}), "-speed = 2\n+speed = 3\n");
}

}  // namespace
}  // namespace cls::tournament
