// Rounds, values of pairs, and the test that stops candidates.
#include "tournament/tuning/race.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "league/rating/betting.h"
#include "league/schedule/schedule.h"

namespace cls::tournament {
namespace {

// A pairing number of its own for each round of each generation.
int seed_number(const TuneConfig& config, int generation, int round) {
  return (generation - 1) * config.pairs + round;
}

double value_of_pair(const TuneConfig& config, std::span<const ScheduledMatch* const> matches,
                     int candidate) {
  const int limit = config.measure == Measure::kPoints  ? 1
                    : config.measure == Measure::kGoals ? config.max_goals
                                                        : config.max_goals * kValueSteps;
  int sum = 0;
  for (const ScheduledMatch* match : matches) {
    const int counted = counted_value(*match->outcome, config.measure, limit);
    sum += match->fixture.left == candidate ? counted : -counted;
  }
  return 0.5 + sum / (4.0 * limit);
}

// The pair of a candidate in a round; nothing when a match is missing or invalid.
using Rounds = std::vector<std::vector<std::optional<double>>>;

Rounds rounds_of(const TuneConfig& config, const Race& race,
                 std::span<const ScheduledMatch> matches) {
  std::map<std::pair<int, int>, std::vector<const ScheduledMatch*>> pairs;
  for (const ScheduledMatch& match : matches) {
    if (!match.outcome || !match.outcome->counts()) continue;
    for (const int team : {match.fixture.left, match.fixture.right}) {
      if (team < race.candidates) pairs[{match.fixture.round, team}].push_back(&match);
    }
  }

  Rounds rounds;
  for (const auto& [place, both] : pairs) {
    const auto [round, team] = place;
    if (both.size() != 2) continue;
    rounds.resize(std::max(rounds.size(), base::index(round)));
    auto& values = rounds[base::index(round) - 1];
    values.resize(base::index(race.candidates));
    values[base::index(team)] = value_of_pair(config, both, team);
  }
  return rounds;
}

// Half of the candidates always play to the end: the optimizer needs their order.
std::size_t min_playing(const Race& race) {
  return base::index(std::max(2, (race.candidates + 1) / 2));
}

// The average of a round over the candidates that still play, without `candidate`.
std::optional<double> average_of_others(const std::vector<std::optional<double>>& round,
                                        const std::vector<RaceResult>& results,
                                        std::size_t candidate) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < round.size(); ++i) {
    if (i == candidate || results[i].stopped || !round[i]) continue;
    sum += *round[i];
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

// The test of a candidate against the average of the others, by bets on the differences.
BettingTest test_of(const TuneConfig& config) {
  constexpr double kWorse = 0.45;  // of differences scaled to 0 to 1, where 1/2 is an equal
  constexpr double kTypicalVariance = 0.06;
  return BettingTest({kWorse, 0.5, 0.05, config.stop}, kTypicalVariance);
}

}  // namespace

double RaceResult::mean() const {
  if (pairs.empty()) return 0.5;
  return std::accumulate(pairs.begin(), pairs.end(), 0.0) / static_cast<double>(pairs.size());
}

std::vector<RaceResult> race_results(const TuneConfig& config, const Race& race,
                                     std::span<const ScheduledMatch> matches) {
  const std::size_t count = base::index(race.candidates);
  std::vector<RaceResult> results(count);
  std::vector<BettingTest> tests(count, test_of(config));
  for (auto& round : rounds_of(config, race, matches)) {
    round.resize(count);

    std::vector<std::size_t> worse;
    for (std::size_t i = 0; i < count; ++i) {
      if (!round[i] || results[i].stopped) continue;
      results[i].pairs.push_back(*round[i]);
      const auto others = average_of_others(round, results, i);
      if (!others || config.stop <= 0) continue;
      tests[i].add(0.5 + (*round[i] - *others) / 2);
      if (tests[i].for_h0() >= 1 / config.stop) worse.push_back(i);
    }

    std::ranges::stable_sort(worse, {}, [&](std::size_t i) { return results[i].mean(); });

    auto playing = base::index(std::ranges::count(results, false, &RaceResult::stopped));
    for (const std::size_t i : worse) {
      if (playing <= min_playing(race)) break;
      results[i].stopped = true;
      --playing;
    }
  }
  return results;
}

std::vector<Fixture> next_round(const TuneConfig& config, const Race& race,
                                std::span<const ScheduledMatch> so_far) {
  const int round = so_far.empty() ? 1 : so_far.back().fixture.round + 1;
  if (round > config.pairs) return {};
  const auto results = race_results(config, race, so_far);

  int index = static_cast<int>(so_far.size());
  int pairing = so_far.empty() ? 0 : so_far.back().fixture.pairing;
  std::vector<Fixture> fixtures;
  const bool direct = race.opponents == 0;
  for (int candidate = 0; candidate < (direct ? 1 : race.candidates); ++candidate) {
    if (results[base::index(candidate)].stopped) continue;
    const int opponent = direct ? 1 : race.candidates + (round - 1) % race.opponents;
    ++pairing;
    for (const bool swapped : {false, true}) {
      fixtures.push_back(
          {.index = ++index,
           .round = round,
           .stage = "",
           .pairing = pairing,
           .left = swapped ? opponent : candidate,
           .right = swapped ? candidate : opponent,
           .seed = pairing_seed(config.seed, seed_number(config, race.generation, round))});
    }
  }
  return fixtures;
}

std::vector<double> ranking_values(const TuneConfig& config,
                                   const std::vector<RaceResult>& results) {
  std::vector<double> values;
  for (const RaceResult& result : results) {
    const double missing = config.pairs - static_cast<double>(result.pairs.size());
    values.push_back(result.stopped ? result.mean() - 1 - missing : result.mean());
  }
  return values;
}

}  // namespace cls::tournament
