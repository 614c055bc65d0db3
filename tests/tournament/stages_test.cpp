// Tournaments in stages: draws, tables and ladders, with results of the league and made-up ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "soccer/random.h"
#include "tests/support/files.h"
#include "tests/tournament/fake_executor.h"
#include "tournament/config/config_file.h"
#include "tournament/config/preset.h"
#include "tournament/schedule/schedule.h"
#include "tournament/schedule/schedule_check.h"
#include "tournament/store/results_file.h"

namespace cls::tournament {
namespace {

using Names = std::vector<std::string>;

std::filesystem::path fixture_folder(const std::string& name) {
  return tests::fixture("tournament/" + name);
}

TournamentConfig read_valid(const std::filesystem::path& file) {
  const ParsedConfig parsed = read_config(file);
  EXPECT_TRUE(parsed.errors.empty()) << parsed.errors.front();
  EXPECT_EQ(validate(parsed.config), std::vector<std::string>());
  return parsed.config;
}

// A tournament whose results are those of the league.
struct League {
  explicit League(const std::string& folder, const std::map<std::string, Outcome>& corrected = {})
      : config(read_valid(fixture_folder(folder) / "cls.toml")) {
    const auto results = ResultsFile::read(fixture_folder(folder) / "results.txt", config);
    EXPECT_TRUE(results) << results.error().message;
    matches = play_all(config, [&](const Fixture& fixture) {
      if (const auto known = corrected.find(fixture.stage); known != corrected.end()) {
        return known->second;
      }
      const auto outcome = results->find(config, fixture);
      EXPECT_TRUE(outcome) << outcome.error().message;
      return outcome ? *outcome : score(0, 0);
    });
  }

  Names table(const std::string& title) const {
    Names names;
    for (const RankedTable& one : tables(config, matches)) {
      if (one.title != title) continue;
      for (const Standing& row : one.standings) names.push_back(team(row.team));
    }
    return names;
  }

  const std::string& team(int index) const {
    return config.teams[static_cast<std::size_t>(index)].name;
  }

  TournamentConfig config;
  std::vector<ScheduledMatch> matches;
};

TEST(League, Of2025HasItsGroupsAveragesAndFinalStandings) {
  const League league("robocup2025");
  EXPECT_EQ(league.table("seeding round, group B"),
            (Names{"YuShan", "RoboCIn", "Oxsy", "SRBIAU2D", "ITAndroids"}));
  EXPECT_EQ(league.table("first round, group D"),
            (Names{"FRA-UNIted", "YuShan", "Oxsy", "ITAndroids", "RoboTech"}));
  EXPECT_EQ(league.table("second round, group F"),
            (Names{"Oxsy", "RoboCIn", "FRA-UNIted", "SRBIAU2D", "RoboTech"}));
  EXPECT_EQ(league.table("third round, group H"),
            (Names{"Titas", "Oxsy", "FRA-UNIted", "ITAndroids", "RoboTech"}));
  EXPECT_EQ(league.table("average of first round, second round, third round"),
            (Names{"HELIOS", "RoboCIn", "Titas", "Oxsy", "FRA-UNIted", "YuShan", "ITAndroids",
                   "SRBIAU2D", "RoboTech"}));
  EXPECT_EQ(league.table("main round, group I"),
            (Names{"HELIOS", "FRA-UNIted", "RoboCIn", "Oxsy", "Titas"}));
  EXPECT_EQ(league.table("main round, group J"),
            (Names{"YuShan", "SRBIAU2D", "RoboTech", "ITAndroids"}));
  EXPECT_EQ(league.table("final standings"),
            (Names{"HELIOS", "YuShan", "FRA-UNIted", "RoboCIn", "Oxsy", "Titas", "SRBIAU2D",
                   "SIRLab", "RoboTech", "ITAndroids"}));
  EXPECT_TRUE(next_fixtures(league.config, league.matches).empty());
  EXPECT_TRUE(check_schedule(league.config, league.matches));
}

// The board lists 0-1 in the match of YuShan and FRA-UNIted for rank 3, but YuShan as the
// semi-finalist and third. In decisions_test.cpp a decision corrects it.
TEST(League, Of2024HasItsGroupsPointsAndFinalStandings) {
  const League league("robocup2024", {{"final day, rank 3", score(1, 0)}});
  EXPECT_EQ(league.table("seeding round, group A"),
            (Names{"HELIOS", "FRA-UNIted", "RoboCIn", "AETeam", "ITAndroids"}));
  EXPECT_EQ(league.table("average of first round, second round, third round"),
            (Names{"CYRUS", "YuShan", "HELIOS", "RoboCIn", "Oxsy", "FRA-UNIted", "R2D2", "AETeam",
                   "ITAndroids", "Mars"}));
  EXPECT_EQ(
      league.table("main round, group I"),
      (Names{"HELIOS", "CYRUS", "YuShan", "R2D2", "RoboCIn", "FRA-UNIted", "Oxsy", "AETeam"}));
  EXPECT_EQ(league.table("final standings"),
            (Names{"HELIOS", "CYRUS", "YuShan", "FRA-UNIted", "R2D2", "RoboCIn", "Oxsy", "AETeam",
                   "ITAndroids", "Mars"}));
  EXPECT_TRUE(next_fixtures(league.config, league.matches).empty());
}

TEST(League, StandsInTheFileInAnyDirection) {
  const League league("robocup2025");
  const auto results =
      ResultsFile::read(fixture_folder("robocup2025") / "results.txt", league.config);
  ASSERT_TRUE(results);
  for (const ScheduledMatch& match : league.matches) {
    Fixture turned = match.fixture;
    std::swap(turned.left, turned.right);
    const auto outcome = results->find(league.config, turned);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->left_score, match.outcome->right_score);
    EXPECT_EQ(outcome->right_penalties, match.outcome->left_penalties);
  }
}

TEST(ResultsFile, NamesTheLineOfAnError) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 3);
  const auto error = [&config](const std::string& text) {
    const auto parsed = ResultsFile::parse(text, "r.txt", config);
    return parsed ? std::string() : parsed.error().message;
  };
  EXPECT_EQ(error("# nothing\n[x]\nA 1:0 B # note\n"), "");
  EXPECT_EQ(error("[x]\nA 1:0 BB\n"), "r.txt:2: unknown team 'BB'");
  EXPECT_EQ(error("A 1:0 A"), "r.txt:1: 'A' meets itself");
  EXPECT_EQ(error("A 1:0 B\nB 0:1 A\n"), "r.txt:2: a second result of B and A in this stage");
  EXPECT_EQ(error("[x"), "r.txt:1: a stage ends in ']'");
  for (const char* wrong :
       {"A 1:0", "A 1-0 B", "A 1:x B", "A -1:0 B", "A 1:1 4:3 B", "A 1:1 () B"}) {
    EXPECT_EQ(error(wrong).rfind("r.txt:1: must be TEAM GOALS:GOALS TEAM", 0), 0u) << wrong;
  }
  EXPECT_EQ(error("A 2:1 (4:3) B"), "r.txt:1: a shoot-out follows a level match only");
}

TEST(ResultsFile, NamesTheMatchThatItLacks) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 2);
  const auto results = ResultsFile::parse("", "r.txt", config);
  ASSERT_TRUE(results);
  const auto outcome = results->find(config, next_fixtures(config, {})[0]);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().message, "r.txt: no result of A and B, match 1, below []");
}

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
TournamentConfig league_of(int teams) {
  TournamentConfig config = config_of(Format::kStages, teams);
  config.stages = {groups_stage("seeding", 2), groups_stage("round", 2), groups_stage("main", 1),
                   ladder_stage("finals")};
  config.stages[2].ranked_by = {"seeding", "round"};
  config.stages[2].divisions = {teams / 2, teams - teams / 2};
  config.stages[2].legs = 2;
  return config;
}

// Results that depend on the fixture only, with draws where they are possible.
Referee random_results(std::uint64_t seed) {
  return [seed](const Fixture& fixture) {
    soccer::RandomStream random(seed, "results", static_cast<std::uint64_t>(fixture.index));
    Outcome outcome =
        score(static_cast<int>(random.integer(4)), static_cast<int>(random.integer(4)));
    if (fixture.decides && outcome.left_score == outcome.right_score) {
      outcome.left_penalties = 3;
      outcome.right_penalties = random.integer(2) == 0 ? 2 : 4;
    }
    return outcome;
  };
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
    const TournamentConfig config = league_of(teams);
    ASSERT_EQ(validate(config), std::vector<std::string>()) << teams;
    const auto matches = play_all(config, random_results(static_cast<std::uint64_t>(teams)));
    EXPECT_TRUE(next_fixtures(config, matches).empty());
    EXPECT_TRUE(check_schedule(config, matches)) << teams;
    EXPECT_EQ(ranking(config, matches).size(), static_cast<std::size_t>(teams));
  }
}

TEST(Stages, GroupsDifferByOneTeamAtMostAndHoldEveryTeamOnce) {
  for (int teams = 4; teams <= 13; ++teams) {
    TournamentConfig config = config_of(Format::kStages, teams);
    for (int i = 0; i < 4; ++i) config.stages.push_back(groups_stage("s" + std::to_string(i), 2));
    const auto matches = play_all(config, random_results(7));
    for (const Stage& stage : config.stages) {
      const auto groups = teams_by_group(matches_in(matches, stage.name));
      ASSERT_EQ(groups.size(), 2u);
      const std::size_t first = groups.begin()->second.size();
      const std::size_t second = groups.rbegin()->second.size();
      EXPECT_EQ(first + second, static_cast<std::size_t>(teams));
      EXPECT_LE(std::max(first, second) - std::min(first, second), 1u) << teams << stage.name;
      EXPECT_EQ(matches_in(matches, stage.name).size(),
                (first * (first - 1) + second * (second - 1)) / 2);
    }
  }
}

TEST(Stages, GroupsAreDrawnAnewByRank) {
  TournamentConfig config = config_of(Format::kStages, 6);
  config.stages = {groups_stage("one", 2), groups_stage("two", 2)};
  const auto matches = play_all(config, better_wins);
  // A D E and B C F; winners A and B, second D and C, third E and F.
  const auto groups = teams_by_group(matches_in(matches, "two"));
  EXPECT_EQ(groups.at("two, group C"), (std::set<int>{0, 2, 4})) << "A1 B2 A3";
  EXPECT_EQ(groups.at("two, group D"), (std::set<int>{1, 3, 5})) << "B1 A2 B3";
}

TEST(Stages, DivisionsPlayHomeAndAwayInTheOrderOfTheAverages) {
  const TournamentConfig config = league_of(7);
  const auto matches = play_all(config, better_wins);
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
  TournamentConfig config = config_of(Format::kStages, 4);
  config.stages = {groups_stage("round", 1), ladder_stage("finals")};
  // The order of the group is A B C D; then D beats everyone.
  const auto matches = play_all(config, [](const Fixture& fixture) {
    if (!belongs_to(fixture.stage, "finals")) return better_wins(fixture);
    EXPECT_TRUE(fixture.decides);
    return score(0, 1);
  });
  const auto finals = matches_in(matches, "finals");
  EXPECT_EQ(pairs_of(finals), (Names{"C-D", "B-D", "A-D"}));
  EXPECT_EQ(finals[0].fixture.stage, "finals, rank 3");
  EXPECT_EQ(finals[1].fixture.stage, "finals, semi-final");
  EXPECT_EQ(finals[2].fixture.stage, "finals, final");
  EXPECT_EQ(ranking(config, matches), (Names{"D", "A", "B", "C"}));
  EXPECT_EQ(bracket(config, matches).size(), 3u);
}

TEST(Stages, StepladderOfAnyResultsGivesRanksOfItsDefenders) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    TournamentConfig config = config_of(Format::kStages, 8);
    config.stages = {groups_stage("round", 1), ladder_stage("finals")};
    const auto matches = play_all(config, random_results(seed));
    const auto finals = matches_in(matches, "finals");
    ASSERT_EQ(finals.size(), 7u);
    const Names last = ranking(config, matches);
    // Who loses the match of rank N has rank N + 1 at the end.
    for (std::size_t i = 0; i < finals.size(); ++i) {
      const Fixture& fixture = finals[i].fixture;
      const int loser = winner_sign(*finals[i].outcome) > 0 ? fixture.right : fixture.left;
      EXPECT_EQ(last[7 - i], config.teams[static_cast<std::size_t>(loser)].name);
    }
  }
}

TEST(Stages, OnlyTheBestGoOnAndTheOthersKeepTheirRank) {
  TournamentConfig config = config_of(Format::kStages, 7);
  config.stages = {groups_stage("round", 1), Stage()};
  config.stages[1].name = "cup";
  config.stages[1].format = StageFormat::kKnockout;
  config.stages[1].teams = 4;
  ASSERT_EQ(validate(config), std::vector<std::string>());
  const auto matches = play_all(config, [](const Fixture& fixture) {
    return belongs_to(fixture.stage, "cup") ? score(0, 1) : better_wins(fixture);
  });
  EXPECT_EQ(pairs_of(matches_in(matches, "cup")), (Names{"A-D", "B-C", "A-B", "D-C"}));
  EXPECT_EQ(ranking(config, matches), (Names{"C", "D", "B", "A", "E", "F", "G"}));
}

TEST(Stages, TeamsJoinBelowAllOthers) {
  TournamentConfig config = config_of(Format::kStages, 4);
  config.stages = {groups_stage("round", 1), ladder_stage("finals")};
  config.stages[1].join = {"A"};
  ASSERT_EQ(validate(config), std::vector<std::string>());
  const auto matches = play_all(config, better_wins);
  EXPECT_EQ(matches_in(matches, "round").size(), 3u);
  EXPECT_EQ(pairs_of(matches_in(matches, "finals")), (Names{"D-A", "C-A", "B-A"}));
  EXPECT_EQ(ranking(config, std::vector(matches.begin(), matches.begin() + 3)).back(), "A");
}

TEST(Stages, PointsAreCarried) {
  TournamentConfig config = config_of(Format::kStages, 4);
  config.stages = {groups_stage("one", 1), groups_stage("two", 1)};
  config.stages[1].carry = {"one"};
  const auto matches = play_all(config, better_wins);
  std::map<std::string, int> points;
  for (const RankedTable& table : tables(config, matches)) {
    points[table.title] = static_cast<int>(table.standings[0].points);
  }
  EXPECT_EQ(points["one"], 9);
  EXPECT_EQ(points["two"], 18);
}

TEST(Stages, AreReadAndWrittenAsTheyAre) {
  const TournamentConfig config = read_valid(fixture_folder("robocup2025") / "cls.toml");
  const ParsedConfig again = parse_config(format_config(config), "plan.toml");
  ASSERT_TRUE(again.errors.empty()) << again.errors.front();
  EXPECT_EQ(again.config.stages, config.stages);
  TournamentConfig other = config;
  other.stages[4].divisions = {4, 5};
  EXPECT_EQ(first_difference(other, config), "stage 5: divisions is [4, 5], was [5, 4]");
  other = config;
  other.stages[5].join.clear();
  EXPECT_EQ(first_difference(other, config), "stage 6: join is not set, was [\"SIRLab\"]");
}

TEST(Preset, IsAValidConfiguration) {
  for (const std::string_view preset : preset_names()) {
    for (int teams = 0; teams <= 13; ++teams) {
      std::vector<std::string> names;
      for (int i = 0; i < teams; ++i) names.push_back("T" + std::to_string(i));
      // Each two teams of this preset are one.
      const bool in_pairs = preset == "mixed";
      const auto text = preset_config(preset, names);
      if (!text) {
        EXPECT_TRUE(teams < 4 || (in_pairs && teams % 2 != 0)) << text.error().message;
        continue;
      }
      ParsedConfig parsed = parse_config(*text, "cls.toml");
      ASSERT_TRUE(parsed.errors.empty()) << parsed.errors.front();
      const std::size_t named = teams == 0 ? 8 : static_cast<std::size_t>(teams);
      EXPECT_EQ(parsed.config.teams.size(), in_pairs ? named / 2 : named);
      for (TeamEntry& team : parsed.config.teams) team.endpoint = "mock";
      ASSERT_EQ(validate(parsed.config), std::vector<std::string>()) << preset << " " << teams;
      const auto matches = play_all(parsed.config, random_results(3));
      EXPECT_EQ(ranking(parsed.config, matches).size(), parsed.config.teams.size());
    }
  }
  EXPECT_EQ(preset_config("robcup", {}).error().message,
            "unknown preset 'robcup'; did you mean 'robocup'?");
  EXPECT_EQ(preset_config("robocup", {"A", "B", "C"}).error().message,
            "preset 'robocup' requires at least 4 teams, there are 3");
}

std::vector<std::string> errors_of(const std::function<void(TournamentConfig&)>& change) {
  TournamentConfig config = league_of(6);
  change(config);
  return validate(config);
}

TEST(Stages, AreValidated) {
  using Config = TournamentConfig;
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
}  // namespace cls::tournament
