// The betting test: it is fair, its bounds agree with its decision, and how long it takes compared
// with the SPRT. docs/tournaments.md has the table of the long form (CLS_FULL).
#include "league/rating/betting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

#include "league/rating/sprt.h"
#include "league/rating/statistics.h"
#include "soccer/random.h"

namespace cls::league {
namespace {

constexpr double kTypicalVariance = 0.15;

Hypotheses elo40() { return {0.5, score_from_elo(40), 0.05, 0.05}; }

/// Shares of equally spaced samples from 0 to 1.
using Distribution = std::vector<double>;

double value_of(std::size_t outcome, const Distribution& shares) {
  return static_cast<double>(outcome) / static_cast<double>(shares.size() - 1);
}

/// The distribution of the exponential family of `shares` that has this mean.
Distribution with_mean(const Distribution& shares, double target) {
  double low = -200.0;
  double high = 200.0;
  Distribution tilted;
  for (int i = 0; i < 200; ++i) {
    const double tilt = (low + high) / 2;
    tilted = shares;
    for (std::size_t k = 0; k < tilted.size(); ++k) {
      tilted[k] *= std::exp(tilt * (value_of(k, tilted) - target));
    }
    const double sum = total(tilted);
    for (double& one : tilted) one /= sum;
    (mean(tilted) < target ? low : high) = tilt;
  }
  return tilted;
}

/// The average of `wealth` over all sequences of `length` samples, weighted by their probability.
double expectation(const Distribution& shares, int length, const Hypotheses& hypotheses,
                   const std::function<double(const BettingTest&)>& wealth) {
  double sum = 0.0;
  const std::function<void(const BettingTest&, int, double)> visit =
      [&](const BettingTest& test, int left, double probability) {
        if (left == 0) {
          sum += probability * wealth(test);
          return;
        }
        for (std::size_t k = 0; k < shares.size(); ++k) {
          if (shares[k] == 0) continue;
          BettingTest next = test;
          next.add(value_of(k, shares));
          visit(next, left - 1, probability * shares[k]);
        }
      };
  visit(BettingTest(hypotheses, kTypicalVariance), length, 1.0);
  return sum;
}

TEST(Betting, IsFairUnderEachHypothesis) {
  const std::vector<Distribution> shapes = {
      {1, 1, 1, 1, 1},    {8, 0, 1, 0, 6}, {0.01, 1, 20, 1, 0.01},
      {30, 1, 0, 0, 0.1}, {1, 0, 1},       {0, 3, 1, 1, 9}};

  for (const auto& [elo0, elo1] : {std::pair{0.0, 40.0}, {-50.0, 0.0}, {100.0, 300.0}}) {
    const Hypotheses hypotheses = {score_from_elo(elo0), score_from_elo(elo1), 0.05, 0.05};
    for (const Distribution& shape : shapes) {
      const double for_h1 = expectation(with_mean(shape, hypotheses.mean0), 5, hypotheses,
                                        [](const BettingTest& test) { return test.for_h1(); });
      const double for_h0 = expectation(with_mean(shape, hypotheses.mean1), 5, hypotheses,
                                        [](const BettingTest& test) { return test.for_h0(); });
      EXPECT_NEAR(for_h1, 1.0, 1e-9) << elo0;
      EXPECT_NEAR(for_h0, 1.0, 1e-9) << elo1;
      EXPECT_LT(expectation(with_mean(shape, hypotheses.mean0 - 0.05), 5, hypotheses,
                            [](const BettingTest& test) { return test.for_h1(); }),
                1.0)
          << "a worse team loses on average";
    }
  }
}

TEST(Betting, DecidesWalkoversInSixPairs) {
  const auto length = [](double sample, const Hypotheses& hypotheses, Decision expected) {
    BettingTest test(hypotheses, kTypicalVariance);
    int count = 0;
    for (; test.decision() == Decision::kOpen && count < 1000; ++count) test.add(sample);
    EXPECT_EQ(test.decision(), expected);
    return count;
  };

  EXPECT_EQ(length(1.0, elo40(), Decision::kH1), 6);
  EXPECT_LE(length(0.0, elo40(), Decision::kH0), 6);
  EXPECT_LE(length(0.5, elo40(), Decision::kH0), 40) << "25 are the minimum of any valid test";

  Hypotheses strict = elo40();
  strict.alpha = 0.001;
  EXPECT_EQ(length(1.0, strict, Decision::kH1), 12) << "2^-n";
}

TEST(Betting, BoundsAgreeWithItsDecision) {
  soccer::RandomStream random(1, "betting");
  for (int run = 0; run < 60; ++run) {
    const double level = random.unit();
    BettingTest test(elo40(), kTypicalVariance);
    for (int i = 0; i < 40 && test.decision() == Decision::kOpen; ++i) {
      test.add(std::floor(5 * std::min(0.999, random.unit() * (0.5 + level))) / 4);
      const Interval bounds = test.bounds();
      EXPECT_EQ(bounds.low >= elo40().mean0 - 1e-9, test.for_h1() >= 20 - 1e-6);
      EXPECT_EQ(bounds.high <= elo40().mean1 + 1e-9, test.for_h0() >= 20 - 1e-6);
      EXPECT_EQ(test.decision() == Decision::kH1, test.for_h1() >= 20);
    }
  }
}

TEST(Betting, BoundsAreTrivialWithoutSamplesAndNarrowWithMany) {
  BettingTest test(elo40(), kTypicalVariance);
  EXPECT_EQ(test.bounds().low, 0.0);
  EXPECT_EQ(test.bounds().high, 1.0);
  EXPECT_EQ(test.for_h1(), 1.0);
  for (int i = 0; i < 2000; ++i) test.add(i % 4 == 0 ? 0.25 : 0.5);  // 0.4375
  EXPECT_NEAR(test.bounds().low, 0.4375, 0.05);
  EXPECT_NEAR(test.bounds().high, 0.4375, 0.05);
  EXPECT_EQ(test.decision(), Decision::kH0);
}

/// Results of pairs from matches that were played, from worst to best.
struct Table {
  const char* name;
  Distribution pairs;
  Hypotheses hypotheses;
  double typical_variance;
};

/// A mean of half a goal a match, where differences above `max_goals` count as this.
Hypotheses half_a_goal(double max_goals) { return {0.5, 0.5 + 0.25 / max_goals, 0.05, 0.05}; }

/// The sums of two independent matches.
Distribution pairs_of(const Distribution& matches) {
  Distribution pairs(2 * matches.size() - 1);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    for (std::size_t j = 0; j < matches.size(); ++j) pairs[i + j] += matches[i] * matches[j];
  }
  return pairs;
}

// Only the shape matters: with_mean() gives it the mean of a hypothesis.
std::vector<Table> tables() {
  return {
      // 13 matches of mock:planner against helios-base on rcssserver: 4:2 7:1 5:0 5:1 1:2 3:0 6:2
      // 5:0 1:1 4:2 2:3 2:2 1:2. Goal differences from -3 to 3.
      {"points, planner against helios", pairs_of({3, 2, 8}), elo40(), 0.15},
      {"goals, planner against helios", pairs_of({0, 0, 3, 2, 0, 2, 6}), half_a_goal(3), 0.056},
      // A fifth of the matches are draws, the matches of a pair share half of their luck.
      {"points, equal teams, shared luck", {0.28, 0.08, 0.28, 0.08, 0.28}, elo40(), 0.15},
      // 30 pairs of 8 situations of a book, mock:planner with and without two-leg dashes: values
      // from -8 to 8 in steps of a half.
      {"values of situations, planner",
       {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 4,
        1, 1, 0, 4, 2, 5, 5, 2, 1, 0, 0, 1, 0, 0, 0, 2},
       half_a_goal(8),
       0.03125},
  };
}

/// Results of simulated tests.
struct Lengths {
  double h1 = 0.0;  ///< share that accepted H1
  double pairs = 0.0;
};

constexpr int kMaxPairs = 100'000;

/// `add` receives a sample's outcome and returns the decision so far.
template <typename MakeTest>
Lengths simulate(const Distribution& shares, int runs, const MakeTest& make_test) {
  Lengths lengths;
  for (int run = 0; run < runs; ++run) {
    soccer::RandomStream random(static_cast<std::uint64_t>(run) + 1, "betting");
    auto add = make_test();
    Decision decision = Decision::kOpen;
    int pairs = 0;
    for (; decision == Decision::kOpen && pairs < kMaxPairs; ++pairs) {
      double unit = random.unit();
      std::size_t outcome = 0;
      while (outcome + 1 < shares.size() && unit >= shares[outcome]) unit -= shares[outcome++];
      decision = add(outcome);
    }
    EXPECT_NE(decision, Decision::kOpen);
    lengths.h1 += decision == Decision::kH1;
    lengths.pairs += pairs;
  }
  return {lengths.h1 / runs, lengths.pairs / runs};
}

Lengths with_betting(const Table& table, const Distribution& shares, int runs) {
  return simulate(shares, runs, [&] {
    return [&, test = BettingTest(table.hypotheses, table.typical_variance)](
               std::size_t outcome) mutable {
      test.add(value_of(outcome, shares));
      return test.decision();
    };
  });
}

Lengths with_sprt(const Table& table, const Distribution& shares, int runs) {
  return simulate(shares, runs, [&] {
    return [&, seen = Frequencies(shares.size())](std::size_t outcome) mutable {
      seen[outcome] += 1;
      return sprt_state(seen, table.hypotheses).decision;
    };
  });
}

// Error rates within alpha and beta, and never more than 1.3 times the pairs of the SPRT at its own
// hypotheses.
TEST(Betting, ErrorRatesAndLengthsOnPlayedTables) {
  const bool full = std::getenv("CLS_FULL") != nullptr;
  const int runs = full ? 100'000 : 1'000;
  const int sprt_runs = full ? 10'000 : 500;
  const double max_rate = 0.05 + 3 * std::sqrt(0.05 * 0.95 / runs);

  for (const Table& table : tables()) {
    const Hypotheses& h = table.hypotheses;
    for (const double mean : {h.mean0, h.mean1}) {
      const Distribution shares = with_mean(table.pairs, mean);
      const Lengths betting = with_betting(table, shares, runs);
      const Lengths sprt = with_sprt(table, shares, sprt_runs);
      const bool at_h0 = mean == h.mean0;
      const auto error = [&](const Lengths& of) { return at_h0 ? of.h1 : 1 - of.h1; };
      std::printf("%-40s %s  error %.4f, sprt %.4f  pairs %6.1f, sprt %6.1f: %.2f\n", table.name,
                  at_h0 ? "H0" : "H1", error(betting), error(sprt), betting.pairs, sprt.pairs,
                  betting.pairs / sprt.pairs);
      EXPECT_LE(error(betting), max_rate) << table.name;
      EXPECT_LE(betting.pairs, 1.3 * sprt.pairs) << table.name;
    }
  }
}

// The larger the difference, the fewer pairs.
TEST(Betting, LengthsBySizeOfTheDifference) {
  const bool full = std::getenv("CLS_FULL") != nullptr;
  const int runs = full ? 100'000 : 500;
  for (const Table& table : tables()) {
    double last = 1e9;
    for (const double mean : {0.6, 0.7, 0.8, 0.9, 0.97, 0.999}) {
      const Distribution shares = with_mean(table.pairs, mean);
      const Lengths betting = with_betting(table, shares, runs);
      const Lengths sprt = with_sprt(table, shares, full ? 2'000 : 200);
      std::printf("%-40s mean %.3f  pairs %6.1f, sprt %6.1f: %.2f\n", table.name, mean,
                  betting.pairs, sprt.pairs, betting.pairs / sprt.pairs);
      EXPECT_LT(betting.pairs, last) << table.name << " " << mean;
      last = betting.pairs;
    }
    EXPECT_LE(last, 7) << table.name;
  }
}

}  // namespace
}  // namespace cls::league
