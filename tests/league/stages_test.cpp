// Stages: draws, tables and ladders of made-up results.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "league/matches/stage_name.h"
#include "league/schedule/schedule.h"
#include "league/schedule/schedule_check.h"
#include "tests/league/made_up_results.h"

namespace cls::league {
namespace {

using Names = std::vector<std::string>;

Stage groups_stage(const std::string& name, int groups) {
  Stage stage;
  stage.name = name;
  stage.groups = groups;
  return stage;
}

Stage ladder_stage(const std::string& name) {
  Stage stage;
  stage.name = name;
  stage.format = StageFormat::kStepladder;
  return stage;
}

// Two rounds in two groups, divisions by average points, and a stepladder.
Competition league_of(int teams) {
  Competition competition = competition_of(Format::kStages, teams);
  competition.stages = {groups_stage("seeding", 2), groups_stage("round", 2),
                        groups_stage("main", 1), ladder_stage("finals")};
  competition.stages[2].ranked_by = {"seeding", "round"};
  competition.stages[2].divisions = {teams / 2, teams - teams / 2};
  competition.stages[2].legs = 2;
  return competition;
}

std::vector<ScheduledMatch> matches_in(const std::vector<ScheduledMatch>& all,
                                       const std::string& stage) {
  std::vector<ScheduledMatch> found;
  for (const ScheduledMatch& match : all) {
    if (belongs_to(match.fixture.stage, stage)) found.push_back(match);
  }
  return found;
}

std::map<std::string, std::set<int>> teams_by_group(const std::vector<ScheduledMatch>& matches) {
  std::map<std::string, std::set<int>> groups;
  for (const ScheduledMatch& match : matches) {
    std::string group = match.fixture.stage;
    if (const std::size_t leg = group.find(", leg "); leg != group.npos) group.resize(leg);
    groups[group].insert(match.fixture.left);
    groups[group].insert(match.fixture.right);
  }
  return groups;
}

TEST(Stages, AreAFunctionOfTheResultsSoFar) {
  for (int teams = 4; teams <= 13; ++teams) {
    const Competition competition = league_of(teams);
    ASSERT_EQ(competition_errors(competition), std::vector<std::string>()) << teams;
    const auto matches = play_all(competition, random_results(static_cast<std::uint64_t>(teams)));
    EXPECT_TRUE(next_fixtures(competition, matches).empty());
    EXPECT_TRUE(check_schedule(competition, matches)) << teams;
    EXPECT_EQ(ranking(competition, matches).size(), base::index(teams));
  }
}

TEST(Stages, GroupsDifferByOneTeamAtMostAndHoldEveryTeamOnce) {
  for (int teams = 4; teams <= 13; ++teams) {
    Competition competition = competition_of(Format::kStages, teams);
    for (int i = 0; i < 4; ++i)
      competition.stages.push_back(groups_stage("s" + std::to_string(i), 2));
    const auto matches = play_all(competition, random_results(7));
    for (const Stage& stage : competition.stages) {
      const auto groups = teams_by_group(matches_in(matches, stage.name));
      ASSERT_EQ(groups.size(), 2u);
      const std::size_t first = groups.begin()->second.size();
      const std::size_t second = groups.rbegin()->second.size();
      EXPECT_EQ(first + second, base::index(teams));
      EXPECT_LE(std::max(first, second) - std::min(first, second), 1u) << teams << stage.name;
      EXPECT_EQ(matches_in(matches, stage.name).size(),
                (first * (first - 1) + second * (second - 1)) / 2);
    }
  }
}

TEST(Stages, GroupsAreDrawnAnewByRank) {
  Competition competition = competition_of(Format::kStages, 6);
  competition.stages = {groups_stage("one", 2), groups_stage("two", 2)};
  const auto matches = play_all(competition, better_wins);
  // A D E and B C F; winners A and B, second D and C, third E and F.
  const auto groups = teams_by_group(matches_in(matches, "two"));
  EXPECT_EQ(groups.at("two, group C"), (std::set<int>{0, 2, 4})) << "A1 B2 A3";
  EXPECT_EQ(groups.at("two, group D"), (std::set<int>{1, 3, 5})) << "B1 A2 B3";
}

TEST(Stages, DivisionsPlayHomeAndAwayInTheOrderOfTheAverages) {
  const Competition competition = league_of(7);
  const auto matches = play_all(competition, better_wins);
  const auto main = matches_in(matches, "main");
  const auto groups = teams_by_group(main);

  EXPECT_EQ(groups.at("main, group E"), (std::set<int>{0, 1, 2}));
  EXPECT_EQ(groups.at("main, group F"), (std::set<int>{3, 4, 5, 6}));

  std::map<std::pair<int, int>, int> pairs;
  std::set<std::uint64_t> seeds;
  for (const ScheduledMatch& match : main) {
    ++pairs[{match.fixture.left, match.fixture.right}];
    seeds.insert(match.fixture.seed);
  }
  for (const auto& [pair, count] : pairs) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(pairs.contains({pair.second, pair.first}));
  }

  EXPECT_EQ(seeds.size(), main.size());
}

TEST(Stages, StepladderLetsTheWinnerClimb) {
  Competition competition = competition_of(Format::kStages, 4);
  competition.stages = {groups_stage("round", 1), ladder_stage("finals")};
  // The order of the group is A B C D; then D beats everyone.
  const auto matches = play_all(competition, [](const Fixture& fixture) {
    if (!belongs_to(fixture.stage, "finals")) return better_wins(fixture);
    EXPECT_TRUE(fixture.decides);
    return score(0, 1);
  });
  const auto finals = matches_in(matches, "finals");

  EXPECT_EQ(pairs_of(finals), (Names{"C-D", "B-D", "A-D"}));
  EXPECT_EQ(finals[0].fixture.stage, "finals, rank 3");
  EXPECT_EQ(finals[1].fixture.stage, "finals, semi-final");
  EXPECT_EQ(finals[2].fixture.stage, "finals, final");
  EXPECT_EQ(ranking(competition, matches), (Names{"D", "A", "B", "C"}));
  EXPECT_EQ(bracket(competition, matches).size(), 3u);
}

TEST(Stages, StepladderOfAnyResultsGivesRanksOfItsDefenders) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Competition competition = competition_of(Format::kStages, 8);
    competition.stages = {groups_stage("round", 1), ladder_stage("finals")};
    const auto matches = play_all(competition, random_results(seed));
    const auto finals = matches_in(matches, "finals");
    ASSERT_EQ(finals.size(), 7u);
    const Names last = ranking(competition, matches);
    // Who loses the match of rank N has rank N + 1 at the end.
    for (std::size_t i = 0; i < finals.size(); ++i) {
      const Fixture& fixture = finals[i].fixture;
      const int loser = winner_sign(*finals[i].outcome) > 0 ? fixture.right : fixture.left;
      EXPECT_EQ(last[7 - i], competition.team(loser));
    }
  }
}

TEST(Stages, OnlyTheBestGoOnAndTheOthersKeepTheirRank) {
  Competition competition = competition_of(Format::kStages, 7);
  competition.stages = {groups_stage("round", 1), Stage()};
  competition.stages[1].name = "cup";
  competition.stages[1].format = StageFormat::kKnockout;
  competition.stages[1].teams = 4;

  ASSERT_EQ(competition_errors(competition), std::vector<std::string>());

  const auto matches = play_all(competition, [](const Fixture& fixture) {
    return belongs_to(fixture.stage, "cup") ? score(0, 1) : better_wins(fixture);
  });
  EXPECT_EQ(pairs_of(matches_in(matches, "cup")), (Names{"A-D", "B-C", "A-B", "D-C"}));
  EXPECT_EQ(ranking(competition, matches), (Names{"C", "D", "B", "A", "E", "F", "G"}));
}

// Stage two leaves the last of each group out; stage three is for all teams again.
TEST(Stages, TeamsThatAStageLeftOutTakePartInTheNext) {
  for (const int teams : {0, 6}) {
    Competition competition = competition_of(Format::kStages, 6);
    competition.stages = {groups_stage("one", 2), groups_stage("two", 2), groups_stage("three", 2)};
    competition.stages[1].teams = 4;
    competition.stages[2].teams = teams;
    ASSERT_EQ(competition_errors(competition), std::vector<std::string>());

    const auto matches = play_all(competition, better_wins);
    EXPECT_EQ(matches_in(matches, "two").size(), 2u);
    EXPECT_EQ(matches_in(matches, "three").size(), 6u) << teams;
    const auto groups = teams_by_group(matches_in(matches, "three"));
    EXPECT_EQ(groups.at("three, group E").size(), 3u);
    EXPECT_EQ(groups.at("three, group F").size(), 3u);
  }
}

TEST(Stages, TeamsThatTwoStagesLeftOutKeepTheirRanks) {
  Competition competition = competition_of(Format::kStages, 6);
  competition.stages = {groups_stage("one", 1), groups_stage("two", 2), groups_stage("three", 2)};
  competition.stages[1].teams = competition.stages[2].teams = 4;
  const auto matches = play_all(competition, better_wins);

  EXPECT_EQ(matches_in(matches, "three").size(), 2u);

  const auto table = tables(competition, matches).back().standings;
  EXPECT_EQ(competition.team(table[4].team), "E");
  EXPECT_EQ(table[4].rank, 5);
  EXPECT_EQ(competition.team(table[5].team), "F");
  EXPECT_EQ(table[5].rank, 6);
}

TEST(Stages, TeamsJoinBelowAllOthers) {
  Competition competition = competition_of(Format::kStages, 4);
  competition.stages = {groups_stage("round", 1), ladder_stage("finals")};
  competition.stages[1].join = {"A"};
  ASSERT_EQ(competition_errors(competition), std::vector<std::string>());
  const auto matches = play_all(competition, better_wins);
  EXPECT_EQ(matches_in(matches, "round").size(), 3u);
  EXPECT_EQ(pairs_of(matches_in(matches, "finals")), (Names{"D-A", "C-A", "B-A"}));
  EXPECT_EQ(ranking(competition, std::vector(matches.begin(), matches.begin() + 3)).back(), "A");
}

TEST(Stages, PointsAreCarried) {
  Competition competition = competition_of(Format::kStages, 4);
  competition.stages = {groups_stage("one", 1), groups_stage("two", 1)};
  competition.stages[1].carry = {"one"};
  const auto matches = play_all(competition, better_wins);
  std::map<std::string, int> points;
  for (const RankedTable& table : tables(competition, matches)) {
    points[table.title] = static_cast<int>(table.standings[0].points);
  }
  EXPECT_EQ(points["one"], 9);
  EXPECT_EQ(points["two"], 18);
}

std::vector<std::string> errors_of(const std::function<void(Competition&)>& change) {
  Competition competition = league_of(6);
  change(competition);
  return competition_errors(competition);
}

TEST(Stages, AreValidated) {
  using Config = Competition;
  const auto only = [](const std::function<void(Config&)>& change) {
    const auto errors = errors_of(change);
    return errors.size() == 1 ? errors[0] : "not one error but " + std::to_string(errors.size());
  };

  EXPECT_EQ(only([](Config& c) { c.stages.clear(); }),
            "format 'stages' requires [[stages]], each with a name");
  EXPECT_EQ(only([](Config& c) { c.format = Format::kSwiss; }),
            "[[stages]] belong to format 'stages', not to 'swiss'");
  EXPECT_EQ(only([](Config& c) { c.rounds = 2; }), "rounds: a stage has `legs` instead");
  EXPECT_EQ(only([](Config& c) {
              c.stages[1].name = "a, b";
              c.stages[2].ranked_by = {"seeding"};
            }),
            "stage 'a, b': a name has at most 60 characters, and no comma, bracket or line break");
  EXPECT_EQ(only([](Config& c) { c.stages[2].ranked_by = {"seding"}; }),
            "stage 'main': ranked_by: unknown earlier stage 'seding'; did you mean 'seeding'?");
  EXPECT_EQ(only([](Config& c) {
              c.stages[2].divisions = {4, 4};
            }),
            "stage 'main': divisions = [4, 4] are for 8 teams, there are 6");
  EXPECT_EQ(only([](Config& c) { c.stages[0].groups = 4; }),
            "stage 'seeding': groups = 4 require at least 8 teams, there are 6");
  EXPECT_EQ(only([](Config& c) {
              c.stages[0].drawn = {{"A", "B", "C"}, {"D", "E"}};
            }),
            "stage 'seeding': groups: 'F' is in none of them");
  EXPECT_EQ(only([](Config& c) { c.stages[3].join = {"Z"}; }),
            "stage 'finals': join: unknown team 'Z'");
  EXPECT_EQ(only([](Config& c) { c.stages[3].teams = 7; }),
            "stage 'finals': teams = 7: only 6 are left");
  EXPECT_EQ(only([](Config& c) { c.stages[3].groups = 2; }),
            "stage 'finals': groups, divisions and carry are keys of format 'groups', not of "
            "'stepladder'");
}

}  // namespace
}  // namespace cls::league
