// Ratings: published values, edge cases, and the error rates of the sequential test.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "league/matches/head_to_head.h"
#include "league/rating/bradley_terry.h"
#include "league/rating/sprt.h"
#include "league/rating/statistics.h"
#include "league/schedule/schedule.h"
#include "soccer/random.h"
#include "tests/league/made_up_results.h"

namespace cls::league {
namespace {

using soccer::EndReason;

TEST(Rating, WilsonIntervalsMatchPublishedValues) {
  // Newcombe 1998, table I: 81 of 263, 15 of 148, 0 of 20, 1 of 29.
  const auto expect = [](double k, double n, double low, double high) {
    const Interval interval = wilson(k, n);
    EXPECT_NEAR(interval.low, low, 5e-5) << k << "/" << n;
    EXPECT_NEAR(interval.high, high, 5e-5) << k << "/" << n;
  };
  expect(81, 263, 0.2553, 0.3662);
  expect(15, 148, 0.0624, 0.1605);
  expect(0, 20, 0.0, 0.1611);
  expect(1, 29, 0.0061, 0.1718);
  expect(0, 0, 0.0, 1.0);
}

TEST(Rating, EloAndSuperiorityMatchOtherTools) {
  const Frequencies pairs = {10789, 19328, 33806, 19402, 10543};
  const Estimate many = estimate(mean(pairs), variance(pairs), static_cast<int>(total(pairs)));
  EXPECT_NEAR(many.elo, -0.7736, 1e-4);
  EXPECT_NEAR((many.elo_interval.high - many.elo_interval.low) / 2, 1.2776, 1e-4);
  EXPECT_NEAR(many.superiority, 0.11766, 1e-5);

  const Frequencies games = {50, 40, 70};
  const Estimate few = estimate(mean(games), variance(games), 160);
  EXPECT_NEAR(few.elo, 43.658, 1e-3);
  EXPECT_NEAR((few.elo_interval.high - few.elo_interval.low) / 2, 47.168, 1e-3);
  EXPECT_NEAR(few.superiority, 0.96749, 1e-5);
  EXPECT_NEAR(score_from_elo(elo_from_score(0.7)), 0.7, 1e-12);
}

TEST(Rating, EstimatesAreFiniteInEdgeCases) {
  const Estimate none = estimate(0.5, 0.0, 0);
  EXPECT_EQ(none.superiority, 0.5);
  EXPECT_EQ(none.score_interval.low, 0.0);
  EXPECT_EQ(none.score_interval.high, 1.0);

  const Estimate all_won = estimate(1.0, 0.0, 10);
  EXPECT_NEAR(all_won.elo, 1199.8, 0.1);
  EXPECT_NEAR(all_won.score_interval.low, 0.7225, 1e-4) << "Wilson interval";
  EXPECT_NEAR(all_won.superiority, 1 - std::pow(0.5, 11), 1e-12);

  const Estimate all_drawn = estimate(0.5, 0.0, 10);
  EXPECT_EQ(all_drawn.superiority, 0.5);
  EXPECT_NEAR(all_drawn.score_interval.low, 0.3612, 1e-4) << "ten draws do not prove equality";
}

TEST(Rating, IntervalAndSuperiorityAgree) {
  for (int games = 2; games <= 29; ++games) {
    for (int won = 0; won <= games; ++won) {
      for (int lost = 0; won + lost <= games; ++lost) {
        const WinDrawLoss record{won, games - won - lost, lost};
        if (record.variance() == 0.0) continue;
        const Estimate strength = estimate(record.score(), record.variance(), games);
        EXPECT_EQ(strength.superiority > 0.975, strength.score_interval.low > 0.5)
            << won << " won, " << lost << " lost of " << games;
        EXPECT_EQ(strength.superiority < 0.025, strength.score_interval.high < 0.5);
      }
    }
  }
}

// Values of many sizes are not wins and losses: 27 quartets of a comparison that was *better*.
TEST(Rating, FewResultsHaveTheirOwnVariance) {
  const Estimate close = estimate(0.588, 0.0115, 27);
  EXPECT_NEAR(close.score_interval.low, 0.5054, 1e-4);
  EXPECT_NEAR(close.score_interval.high, 0.6487, 1e-4);
  EXPECT_GT(close.superiority, 0.975);
}

// The share of intervals that have the true mean; Wilson's own of wins and losses waver about 95 %.
TEST(Rating, IntervalsOfFewResultsCover) {
  const auto covered = [](int count, double mean, auto draw) {
    constexpr int kTrials = 4000;
    soccer::RandomStream random(7, "coverage");
    int inside = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      double sum = 0.0;
      double squares = 0.0;
      for (int i = 0; i < count; ++i) {
        const double result = draw(random);
        sum += result;
        squares += result * result;
      }
      const double average = sum / count;
      const double variance = std::max(0.0, squares / count - average * average);
      const Interval interval = estimate(average, variance, count).score_interval;
      inside += interval.low <= mean && mean <= interval.high ? 1 : 0;
    }
    return inside / double{kTrials};
  };

  const auto games = [](soccer::RandomStream& random) {
    const double u = random.unit();
    return u < 0.4 ? 1.0 : u < 0.9 ? 0.5 : 0.0;
  };
  const auto values = [](soccer::RandomStream& random) { return random.uniform(0.4, 0.7); };
  for (const int count : {2, 5, 12, 29}) {
    EXPECT_GT(covered(count, 0.65, games), 0.95) << count << " games";
    EXPECT_GT(covered(count, 0.55, values), 0.95) << count << " values";
  }
}

TEST(Sprt, LikelihoodRatiosMatchOtherTools) {
  const auto llr = [](const Frequencies& seen, double elo0, double elo1) {
    return log_likelihood_ratio(seen, score_from_elo(elo0), score_from_elo(elo1));
  };
  EXPECT_NEAR(llr({10789, 19328, 33806, 19402, 10543}, -3, 1), 2.131068, 1e-6);
  EXPECT_NEAR(llr({39, 2226, 31451, 2412, 40}, 0.2, 0.9), 2.162543, 1e-6);
  EXPECT_NEAR(llr({50, 40, 70}, 0, 35), 1.608825, 1e-6);
}

Hypotheses elo_hypotheses(double elo0, double elo1) {
  return {score_from_elo(elo0), score_from_elo(elo1), 0.05, 0.05};
}

TEST(Sprt, DecidesEdgeCases) {
  const Hypotheses hypotheses = elo_hypotheses(0, 40);
  EXPECT_NEAR(upper_llr(hypotheses), 2.944, 1e-3);
  EXPECT_NEAR(lower_llr(hypotheses), -2.944, 1e-3);

  const auto decision = [&](const Frequencies& seen) {
    return sprt_state(seen, hypotheses).decision;
  };
  EXPECT_EQ(decision({0, 0, 0, 0, 0}), Decision::kOpen);
  EXPECT_EQ(sprt_state({0, 0, 0, 0, 0}, hypotheses).llr, 0.0);
  EXPECT_EQ(decision({0, 0, 0, 0, 3}), Decision::kOpen);
  EXPECT_EQ(decision({0, 0, 0, 0, 60}), Decision::kH1);
  EXPECT_EQ(decision({60, 0, 0, 0, 0}), Decision::kH0);
  EXPECT_EQ(decision({0, 0, 500, 0, 0}), Decision::kH0);

  // Extreme bounds still give finite values.
  for (const double huge : {100.0, 1000.0, 5000.0}) {
    const double llr =
        log_likelihood_ratio({1, 2, 3, 4, 5}, score_from_elo(-huge), score_from_elo(huge));
    EXPECT_TRUE(std::isfinite(llr)) << huge;
  }
}

// Pairs of games between teams at an Elo difference; the games of a pair share half of their luck.
class Opponents {
 public:
  Opponents(double elo, std::uint64_t seed) : random_(seed, "sprt"), score_(score_from_elo(elo)) {}

  std::size_t pair() {
    const double luck = random_.unit();
    return base::index(game(luck) + game(random_.unit() < 0.5 ? luck : random_.unit()));
  }

 private:
  // A fifth of the games are draws.
  int game(double luck) const { return luck < score_ - 0.1 ? 2 : luck < score_ + 0.1 ? 1 : 0; }

  soccer::RandomStream random_;
  double score_;
};

struct ErrorRate {
  double h1 = 0.0;  ///< share of runs that accepted H1
  double length = 0.0;
};

ErrorRate simulate(double elo, const Hypotheses& hypotheses, int runs) {
  constexpr int kLimit = 100'000;
  ErrorRate rate;
  for (int run = 0; run < runs; ++run) {
    Opponents opponents(elo, static_cast<std::uint64_t>(run) + 1);
    Frequencies seen(5);
    SprtState state;
    int pairs = 0;
    for (; state.decision == Decision::kOpen && pairs < kLimit; ++pairs) {
      seen[opponents.pair()] += 1;
      state = sprt_state(seen, hypotheses);
    }
    EXPECT_NE(state.decision, Decision::kOpen);
    rate.h1 += state.decision == Decision::kH1;
    rate.length += pairs;
  }

  rate.h1 /= runs;
  rate.length /= runs;
  return rate;
}

// Distant bounds keep it short; docs/tournaments.md has the table of 10 000 runs (CLS_FULL).
TEST(Sprt, ErrorRatesStayWithinAlphaAndBeta) {
  const bool full = std::getenv("CLS_FULL") != nullptr;
  const int runs = full ? 10'000 : 1'000;
  std::vector<std::pair<double, double>> bounds = {{0.0, 80.0}, {0.0, 160.0}};
  if (full) bounds.insert(bounds.begin(), {0.0, 40.0});
  for (const auto& [elo0, elo1] : bounds) {
    const Hypotheses hypotheses = elo_hypotheses(elo0, elo1);
    const ErrorRate at_h0 = simulate(elo0, hypotheses, runs);
    const ErrorRate at_h1 = simulate(elo1, hypotheses, runs);
    // Three standard errors above the nominal rate.
    const double max_rate = 0.05 + 3 * std::sqrt(0.05 * 0.95 / runs);
    EXPECT_LE(at_h0.h1, max_rate) << elo1;
    EXPECT_LE(1 - at_h1.h1, max_rate) << elo1;
    std::printf("elo1 %4.0f, %d runs: alpha %.4f (%.1f pairs), beta %.4f (%.1f pairs)\n", elo1,
                runs, at_h0.h1, at_h0.length, 1 - at_h1.h1, at_h1.length);
  }
}

// Within a tenth of the simulated lengths that docs/tournaments.md lists.
TEST(Sprt, PredictsItsLength) {
  constexpr double kVariance = 0.15;
  const auto pairs = [&](double llr, double mean, double elo) {
    return expected_results(llr, mean, kVariance, elo_hypotheses(0, elo));
  };

  EXPECT_NEAR(pairs(0, 0.5, 40), 247, 25);
  EXPECT_NEAR(pairs(0, score_from_elo(40), 40), 251, 25);
  EXPECT_NEAR(pairs(0, 0.5, 80), 64, 6);
  EXPECT_NEAR(pairs(0, 0.5, 160), 18, 2);

  const double halfway = (0.5 + score_from_elo(40)) / 2;
  EXPECT_GT(pairs(0, halfway, 40), 300) << "the longest";
  EXPECT_NEAR(pairs(0, halfway + 1e-7, 40), pairs(0, halfway, 40), 1) << "continuous there";
  EXPECT_LT(pairs(2.9, 1.0, 40), 2);
  EXPECT_EQ(pairs(3.0, 0.5, 40), 0) << "decided";
}

TEST(BradleyTerry, GivesTwoTeamsTheEloOfTheirScore) {
  const std::vector<PairResults> results = {{0, 1, 7500, 10000}};
  const Ratings ratings = fit_bradley_terry(2, results);
  EXPECT_NEAR(ratings.elo[0] - ratings.elo[1], elo_from_score(0.75), 0.1);
  EXPECT_NEAR(ratings.elo[0] + ratings.elo[1], 0.0, 1e-9);
  // sqrt(1 / (n p q)) of the difference, half of it against the mean.
  EXPECT_NEAR(ratings.error[0], 1.96 * 173.72 / std::sqrt(10000 * 0.75 * 0.25) / 2, 0.01);
  EXPECT_GT(ratings.superiority[0][1], 0.999999);
}

TEST(BradleyTerry, OrdersTeamsThatNeverMet) {
  // A beats B three of four, B beats C three of four: A is 2 x 191 Elo above C.
  const std::vector<PairResults> results = {{0, 1, 3000, 4000}, {1, 2, 3000, 4000}};
  const Ratings ratings = fit_bradley_terry(3, results);
  EXPECT_NEAR(ratings.elo[0] - ratings.elo[2], 2 * elo_from_score(0.75), 1.0);
  EXPECT_NEAR(ratings.elo[1], 0.0, 1e-6);
  EXPECT_GT(ratings.error[0], ratings.error[1]);
}

TEST(BradleyTerry, IsFiniteWithoutGamesAndWithAllWins) {
  const Ratings none = fit_bradley_terry(3, {});
  EXPECT_NEAR(none.elo[0], 0.0, 1e-9);
  EXPECT_NEAR(none.superiority[0][1], 0.5, 1e-9);
  const Ratings all = fit_bradley_terry(2, std::vector<PairResults>{{0, 1, 10, 10}});
  EXPECT_GT(all.elo[0], 100.0);
  EXPECT_LT(all.elo[0], 1000.0);
  EXPECT_GT(all.error[0], 100.0);
}

TEST(HeadToHead, CountsPairsByTheirPoints) {
  Competition competition = competition_of(Format::kRoundRobin, 2);
  competition.rounds = 4;
  // Pair by pair, for A: win + win, draw + win, loss + loss, win + a crash.
  const std::vector<Outcome> outcomes = {
      score(1, 0), score(0, 1), score(1, 1), score(2, 1),
      score(0, 1), score(1, 0), score(0, 2), fault(EndReason::kCrashed)};
  std::vector<ScheduledMatch> matches;
  for (const Fixture& fixture : next_fixtures(competition, {})) {
    matches.push_back(planned(fixture));
    matches.back().outcome = outcomes[matches.size() - 1];
  }
  const auto all = head_to_heads(matches);

  ASSERT_EQ(all.size(), 1u);

  const HeadToHead& head_to_head = all[0];
  // Rounds 2 and 4 start with B on the left.
  EXPECT_EQ(head_to_head.games.won, 4);
  EXPECT_EQ(head_to_head.games.drawn, 1);
  EXPECT_EQ(head_to_head.games.lost, 2);
  EXPECT_EQ(head_to_head.pairs, (Frequencies{1, 0, 0, 1, 1}));
  EXPECT_EQ(head_to_head.single_games, 1);
  EXPECT_TRUE(head_to_head.paired());
  EXPECT_EQ(head_to_head.strength().count, 3) << "pairs, without the single game";
  EXPECT_EQ(reversed(head_to_head).games.won, 2);
  EXPECT_EQ(reversed(head_to_head).pairs, (Frequencies{1, 1, 0, 0, 1}));
  EXPECT_EQ(record_of(1, all).games.won, 2);
}

}  // namespace
}  // namespace cls::league
