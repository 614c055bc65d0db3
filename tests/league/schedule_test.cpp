// Schedules: pairings, sides and seeds of each format.
#include "league/schedule/schedule.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/league/made_up_results.h"

namespace cls::league {
namespace {

using soccer::EndReason;

using Pairs = std::vector<std::string>;

TEST(Schedule, RoundRobinPairsSwapSidesOnOneSeed) {
  const auto fixtures = next_fixtures(competition_of(Format::kRoundRobin, 3), {});
  ASSERT_EQ(fixtures.size(), 6u);

  std::set<std::string> pairs;
  for (const std::string& pair : pairs_of(fixtures)) pairs.insert(pair);
  EXPECT_EQ(pairs, (std::set<std::string>{"A-B", "B-A", "A-C", "C-A", "B-C", "C-B"}));

  for (std::size_t i = 0; i < fixtures.size(); i += 2) {
    EXPECT_EQ(fixtures[i].index, static_cast<int>(i) + 1);
    EXPECT_EQ(fixtures[i].left, fixtures[i + 1].right);
    EXPECT_EQ(fixtures[i].right, fixtures[i + 1].left);
    EXPECT_EQ(fixtures[i].seed, fixtures[i + 1].seed);
    EXPECT_EQ(fixtures[i].pairing, fixtures[i + 1].pairing);
  }

  EXPECT_NE(fixtures[0].seed, fixtures[2].seed);
}

TEST(Schedule, DependsOnlyOnConfigurationAndSeed) {
  Competition competition = competition_of(Format::kRoundRobin, 5);
  competition.rounds = 3;
  const auto fixtures = next_fixtures(competition, {});
  EXPECT_EQ(fixtures, next_fixtures(competition, {}));
  competition.seed = 2;
  EXPECT_EQ(pairs_of(fixtures), pairs_of(next_fixtures(competition, {})));
  EXPECT_NE(fixtures[0].seed, next_fixtures(competition, {})[0].seed);
  // Fixed values: after a change of the function, existing folders could not be resumed.
  EXPECT_EQ(pairing_seed(1, 1), 1968244302u);
  EXPECT_EQ(pairing_seed(1, 2), 305414156u);
}

TEST(Schedule, PairingSeedsAreDistinct) {
  std::set<std::uint64_t> seeds;
  for (int pairing = 1; pairing <= 200'000; ++pairing) seeds.insert(pairing_seed(5, pairing));
  EXPECT_EQ(seeds.size(), 200'000u);
  EXPECT_GE(*seeds.begin(), 1u);
  EXPECT_LE(*seeds.rbegin(), 0x7fffffffu);
}

TEST(Schedule, RoundRobinHasEveryPairOncePerSideAndRound) {
  for (int teams = 2; teams <= 9; ++teams) {
    Competition competition = competition_of(Format::kRoundRobin, teams);
    competition.rounds = 2;
    std::map<std::string, int> times;
    for (const std::string& pair : pairs_of(next_fixtures(competition, {}))) ++times[pair];
    EXPECT_EQ(static_cast<int>(times.size()), teams * (teams - 1));
    for (const auto& [pair, count] : times) EXPECT_EQ(count, 2) << pair;
  }
}

TEST(Schedule, RoundRobinBalancesSidesWithoutSwapping) {
  for (int teams = 2; teams <= 12; ++teams) {
    Competition competition = competition_of(Format::kRoundRobin, teams);
    competition.swap_sides = false;
    std::vector<int> balance(base::index(teams));
    const auto fixtures = next_fixtures(competition, {});
    EXPECT_EQ(static_cast<int>(fixtures.size()), teams * (teams - 1) / 2);
    for (const Fixture& fixture : fixtures) {
      ++balance[base::index(fixture.left)];
      --balance[base::index(fixture.right)];
    }
    for (const int one : balance) EXPECT_LE(std::abs(one), 2) << teams << " teams";
  }
}

TEST(Schedule, GauntletPairsSubjectsWithAllTeams) {
  Competition competition = competition_of(Format::kGauntlet, 4);
  competition.gauntlet = {"C"};
  competition.swap_sides = false;
  EXPECT_EQ(pairs_of(next_fixtures(competition, {})), (Pairs{"C-A", "C-B", "C-D"}));
  competition.gauntlet = {"C", "A"};
  EXPECT_EQ(pairs_of(next_fixtures(competition, {})), (Pairs{"A-B", "A-C", "A-D", "C-B", "C-D"}));
}

TEST(Schedule, ListKeepsItsOrder) {
  Competition competition = competition_of(Format::kList, 3);
  competition.matches = {{"B", "A"}, {"C", "A"}};
  competition.rounds = 2;
  EXPECT_EQ(pairs_of(next_fixtures(competition, {})),
            (Pairs{"B-A", "A-B", "C-A", "A-C", "B-A", "A-B", "C-A", "A-C"}));
  EXPECT_TRUE(next_fixtures(competition, play_all(competition, better_wins)).empty());
}

TEST(Schedule, GroupsAreFollowedByKnockoutOfTheBest) {
  Competition competition = competition_of(Format::kGroups, 8);
  competition.swap_sides = false;
  const auto matches = play_all(competition, better_wins);
  // Serpentine order: A D E H and B C F G.
  EXPECT_EQ(pairs_of(matches).size(), 6u + 6u + 2u + 2u);

  const std::vector<ScheduledMatch> last(matches.end() - 4, matches.end());
  EXPECT_EQ(pairs_of(last), (Pairs{"A-C", "B-D", "C-D", "A-B"}));
  EXPECT_EQ(last[0].fixture.stage, "semi-final 1");
  EXPECT_EQ(last[2].fixture.stage, "third place");
  EXPECT_EQ(last[3].fixture.stage, "final");
  EXPECT_TRUE(last[0].fixture.decides);
  EXPECT_FALSE(matches[0].fixture.decides);
  EXPECT_EQ(ranking(competition, matches), (Pairs{"A", "B", "C", "D"}));
  EXPECT_EQ(tables(competition, matches)[0].title, "group A");
  EXPECT_EQ(tables(competition, matches).size(), 3u);
}

TEST(Schedule, KnockoutGivesByesToTheBestSeeds) {
  Competition competition = competition_of(Format::kKnockout, 6);
  competition.swap_sides = false;
  EXPECT_EQ(pairs_of(next_fixtures(competition, {})), (Pairs{"D-E", "C-F"}));
  const auto matches = play_all(competition, better_wins);
  EXPECT_EQ(pairs_of(matches), (Pairs{"D-E", "C-F", "A-D", "B-C", "D-C", "A-B"}));
  const auto table = tables(competition, matches).back().standings;
  EXPECT_EQ(ranking(competition, matches), (Pairs{"A", "B", "C", "D", "E", "F"}));
  EXPECT_EQ(table[4].rank, 5);
  EXPECT_EQ(table[5].rank, 5) << "both were eliminated in the same round";
}

TEST(Schedule, KnockoutTieIsDecidedByGoalsThenByDecider) {
  Competition competition = competition_of(Format::kKnockout, 2);
  const auto level = [](const Fixture& fixture) {
    if (!fixture.decides) return fixture.left == 0 ? score(2, 1) : score(1, 0);
    Outcome outcome = score(0, 0);
    outcome.left_penalties = 3;
    outcome.right_penalties = 4;
    return outcome;
  };
  const auto matches = play_all(competition, level);

  EXPECT_EQ(pairs_of(matches), (Pairs{"A-B", "B-A", "A-B"}));
  EXPECT_TRUE(matches[2].fixture.decides);
  EXPECT_NE(matches[2].fixture.seed, matches[0].fixture.seed);
  EXPECT_EQ(ranking(competition, matches), (Pairs{"B", "A"}));

  const auto on_goals = [](const Fixture& fixture) {
    return fixture.left == 0 ? score(3, 1) : score(1, 0);
  };
  EXPECT_EQ(ranking(competition, play_all(competition, on_goals)), (Pairs{"A", "B"}));
}

TEST(Schedule, KnockoutTieIsDrawnByLotAfterThreeDeciders) {
  Competition competition = competition_of(Format::kKnockout, 2);
  const auto level = [](const Fixture&) { return score(0, 0); };
  const auto matches = play_all(competition, level);
  EXPECT_EQ(matches.size(), 5u) << "a pair, then three deciders";
  EXPECT_EQ(ranking(competition, matches).size(), 2u);

  std::set<std::string> winners;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    competition.seed = seed;
    winners.insert(ranking(competition, play_all(competition, level)).front());
  }

  EXPECT_EQ(winners.size(), 2u);
}

TEST(Schedule, KnockoutContinuesAfterInvalidMatches) {
  Competition competition = competition_of(Format::kKnockout, 4);
  const auto broken = [](const Fixture&) { return fault(EndReason::kCrashed); };
  EXPECT_EQ(ranking(competition, play_all(competition, broken)).size(), 4u);
}

TEST(Schedule, DoubleEliminationEliminatesTeamsBySecondLoss) {
  for (int teams = 2; teams <= 11; ++teams) {
    Competition competition = competition_of(Format::kDoubleElimination, teams);
    competition.swap_sides = false;
    const auto matches = play_all(competition, better_wins);
    EXPECT_EQ(static_cast<int>(matches.size()), 2 * teams - 2) << teams;
    std::map<int, int> losses;
    for (const ScheduledMatch& match : matches) {
      ++losses[std::max(match.fixture.left, match.fixture.right)];
    }
    for (int team = 1; team < teams; ++team) EXPECT_EQ(losses[team], 2) << teams << ": " << team;
    EXPECT_EQ(ranking(competition, matches)[0], "A");
    EXPECT_EQ(ranking(competition, matches)[1], "B");
  }
}

TEST(Schedule, DoubleEliminationChallengerMustWinGrandFinalTwice) {
  Competition competition = competition_of(Format::kDoubleElimination, 4);
  competition.swap_sides = false;
  // A loses its first match only, then wins all.
  const auto referee = [](const Fixture& fixture) {
    if (fixture.stage == "winners' round 1, tie 1") return score(0, 1);
    return better_wins(fixture);
  };
  const auto matches = play_all(competition, referee);

  EXPECT_EQ(matches.size(), 7u);
  EXPECT_EQ(matches.back().fixture.stage, "grand final, second");
  EXPECT_EQ(ranking(competition, matches).front(), "A");
}

TEST(Schedule, SwissNeverRepeatsPairingsAndRotatesByes) {
  for (int teams = 2; teams <= 17; ++teams) {
    Competition competition = competition_of(Format::kSwiss, teams);
    const auto matches = play_all(competition, better_wins);
    std::map<std::pair<int, int>, int> met;
    std::map<int, int> played;
    for (const ScheduledMatch& match : matches) {
      ++met[{match.fixture.left, match.fixture.right}];
      ++played[match.fixture.left];
    }
    for (const auto& [pair, times] : met) EXPECT_EQ(times, 1) << teams << " teams";
    for (int team = 0; team < teams; ++team) {
      EXPECT_GE(played[team], rounds_of(competition) - 1) << teams << " teams, at most one bye";
    }
    EXPECT_EQ(matches.back().fixture.round, rounds_of(competition));
  }
}

TEST(Schedule, SwissPairsUpperWithLowerHalfThenEqualPoints) {
  Competition competition = competition_of(Format::kSwiss, 8);
  competition.swap_sides = false;
  const auto matches = play_all(competition, better_wins);
  const std::vector<ScheduledMatch> first(matches.begin(), matches.begin() + 4);
  const std::vector<ScheduledMatch> second(matches.begin() + 4, matches.begin() + 8);
  EXPECT_EQ(pairs_of(first), (Pairs{"A-E", "B-F", "C-G", "D-H"}));
  for (const ScheduledMatch& match : second) {
    EXPECT_EQ(match.fixture.left < 4, match.fixture.right < 4) << "winners meet winners";
  }
  EXPECT_EQ(ranking(competition, matches).front(), "A");
}

TEST(Schedule, RulesSayWhetherMatchesFollowFromResults) {
  for (const FormatRules& rules : formats()) {
    Competition competition = competition_of(rules.format, 6);
    EXPECT_EQ(name(rules.format), rules.name);
    EXPECT_EQ(&rules_of(competition), &rules);
    competition.gauntlet = {"A"};
    competition.matches = {{"A", "B"}};
    if (rules.format == Format::kStages) {
      competition.stages.resize(2);
      competition.stages[0].name = "one";
      competition.stages[1].name = "two";
    }
    ASSERT_EQ(competition_errors(competition), std::vector<std::string>()) << rules.name;

    const std::size_t first = next_fixtures(competition, {}).size();
    EXPECT_EQ(play_all(competition, better_wins).size() > first, rules.later) << rules.name;
  }
}

TEST(Schedule, DrawShufflesSeedingBySeed) {
  Competition competition = competition_of(Format::kKnockout, 16);
  competition.draw = true;
  const auto once = pairs_of(next_fixtures(competition, {}));
  EXPECT_EQ(once, pairs_of(next_fixtures(competition, {})));
  competition.seed = 2;
  EXPECT_NE(once, pairs_of(next_fixtures(competition, {})));
}

}  // namespace
}  // namespace cls::league
