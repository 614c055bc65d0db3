// Decisions on matches: annulled, awarded, replayed, and what they change.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "league/schedule/schedule.h"
#include "league/schedule/schedule_check.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/tournament/fake_executor.h"
#include "tournament/config/config_file.h"
#include "tournament/report/report_document.h"
#include "tournament/report/report_text.h"
#include "tournament/run/tournament_run.h"
#include "tournament/store/decide.h"
#include "tournament/store/decisions_file.h"
#include "tournament/store/folder.h"

namespace cls::tournament {
namespace {

using Names = std::vector<std::string>;

MatchDecision decision_on(int match, DecisionKind kind) {
  MatchDecision decision;
  decision.match = match;
  decision.kind = kind;
  decision.reason = "a protest";
  decision.time = "2026-07-01T10:00:00Z";
  return decision;
}

MatchDecision award(int match, int left, int right) {
  MatchDecision decision = decision_on(match, DecisionKind::kAward);
  decision.left_score = left;
  decision.right_score = right;
  return decision;
}

class DecisionsTest : public testing::Test {
 protected:
  void play(const TournamentConfig& config, const Referee& referee = better_wins,
            std::optional<int> last = std::nullopt) {
    record_.started.clear();
    run_with(config, last, [&](const TournamentConfig&) {
      return base::Result<std::unique_ptr<MatchExecutor>>(std::make_unique<FakeExecutor>(
          [&](const Assignment& one) { return std::optional(referee(one.fixture)); }, record_));
    });
  }

  void run_with(const TournamentConfig& config, std::optional<int> last, const MakeExecutor& make) {
    ASSERT_TRUE(prepare_folder(folder_.path(), config).ok());
    RunOptions options;
    options.folder = folder_.path();
    options.config = config;
    options.last_match = last;
    TournamentObserver observer;
    const auto summary = run_tournament(options, make, observer, signal_);
    ASSERT_TRUE(summary) << summary.error().message;
    const TournamentState now = state();
    EXPECT_TRUE(check_schedule(now.config.competition, now.matches));
  }

  TournamentState state() {
    auto read = read_tournament(folder_.path());
    if (!read) throw std::runtime_error(read.error().message);
    return *std::move(read);
  }

  base::Result<DecisionEffect> decide_on(const MatchDecision& decision, bool redraw = false) {
    TRY_INIT(auto effect, decide(folder_.path(), state().config, decision, redraw));
    if (!effect.problem.empty()) return base::Error{effect.problem};
    return effect;
  }

  Names ranks() {
    const TournamentState now = state();
    return ranking(now.config.competition, now.matches);
  }

  std::vector<int> played() const {
    std::vector<int> numbers;
    for (const Assignment& one : record_.started) numbers.push_back(one.fixture.index);
    return numbers;
  }

  tests::TemporaryFolder folder_;
  FakeExecutor::Record record_;
  std::atomic<int> signal_{0};
};

TournamentConfig ladder_of(int teams) {
  TournamentConfig config = config_of(Format::kStages, teams);
  config.competition.stages.resize(2);
  config.competition.stages[0].name = "round";
  config.competition.stages[1].name = "finals";
  config.competition.stages[1].format = StageFormat::kStepladder;
  return config;
}

TEST_F(DecisionsTest, AnAwardCountsInTheTableAndNotInRatings) {
  TournamentConfig config = config_of(Format::kRoundRobin, 2);
  config.competition.swap_sides = false;
  play(config);
  ASSERT_EQ(ranks(), (Names{"A", "B"}));

  const auto effect = decide_on(award(1, 0, 3));
  ASSERT_TRUE(effect) << effect.error().message;
  EXPECT_FALSE(effect->drawn_again);
  EXPECT_EQ(ranks(), (Names{"B", "A"}));

  const TournamentState now = state();
  EXPECT_FALSE(now.matches[0].outcome->played());
  EXPECT_EQ(now.matches[0].decision->before, "1:0");

  play(config);
  EXPECT_TRUE(played().empty());
  EXPECT_EQ(ranks(), (Names{"B", "A"}));
  ASSERT_TRUE(decide_on(decision_on(1, DecisionKind::kAsPlayed)));
  EXPECT_EQ(ranks(), (Names{"A", "B"}));
  EXPECT_EQ(read_decisions(folder_.path())->size(), 2u);
}

TEST_F(DecisionsTest, AnAwardStandsForAMatchThatIsNotPlayed) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 3);
  play(config, better_wins, 2);
  ASSERT_TRUE(decide_on(award(3, 0, 3)));
  play(config);
  EXPECT_EQ(played(), (std::vector<int>{4, 5, 6}));
}

TEST_F(DecisionsTest, AnAnnulledMatchCountsForNothing) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 2);
  play(config);
  ASSERT_TRUE(decide_on(decision_on(1, DecisionKind::kAnnul)));

  const TournamentState now = state();
  const Standing best = tables(now.config.competition, now.matches).back().standings[0];
  EXPECT_EQ(best.played, 1);
  EXPECT_EQ(best.invalid, 0);

  const MatchCounts counts = count(now.matches);
  EXPECT_EQ(counts.annulled, 1);
  EXPECT_EQ(counts.invalid, 0);
  EXPECT_EQ(counts_text(counts), "2 of 2 matches done, of these 1 annulled");
}

TEST_F(DecisionsTest, AReplayIsAnotherAttemptOnAnotherSeed) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 2);
  play(config);
  const std::uint64_t seed = state().matches[0].fixture.seed;
  ASSERT_TRUE(decide_on(decision_on(1, DecisionKind::kReplay)));
  EXPECT_FALSE(state().matches[0].outcome);

  play(config, [](const Fixture&) { return score(4, 4); });
  ASSERT_EQ(record_.started.size(), 1u);
  EXPECT_EQ(record_.started[0].number, 2);
  EXPECT_NE(record_.started[0].fixture.seed, seed);
  EXPECT_EQ(state().matches[0].outcome->left_score, 4);
  EXPECT_EQ(state().matches[0].decision->before, "1:0");
  // Once more.
  ASSERT_TRUE(decide_on(decision_on(1, DecisionKind::kReplay)));

  play(config);
  EXPECT_EQ(record_.started.at(0).number, 3);

  const auto fixture = read_fixture(folder_.path() / kScheduleFile, 1);
  ASSERT_TRUE(fixture);
  EXPECT_EQ(fixture->seed, record_.started[0].fixture.seed);
}

TEST_F(DecisionsTest, AReplayThatWasRecordedOnlyIsPlannedByTheNextRun) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 2);
  play(config);
  MatchDecision decision = decision_on(2, DecisionKind::kReplay);
  decision.seed = seed_of_replay(state().matches[1].fixture.seed);
  ASSERT_TRUE(write_decisions(folder_.path(), {decision}));  // killed before the store changed
  play(config);
  EXPECT_EQ(played(), (std::vector<int>{2}));
  play(config);
  EXPECT_TRUE(played().empty());
}

TEST_F(DecisionsTest, UnplayedMatchesAreDrawnAnew) {
  const TournamentConfig config = ladder_of(3);
  play(config, better_wins, 3);
  play(config, better_wins, 0);  // draws the first step, and plays nothing
  ASSERT_EQ(state().matches.size(), 4u);
  EXPECT_EQ(state().matches[3].fixture.right, 2);

  // C beats both by decision.
  const TournamentState now = state();
  for (int number = 1; number <= 3; ++number) {
    const Fixture& fixture = now.matches[base::index(number) - 1].fixture;
    if (fixture.left != 2 && fixture.right != 2) continue;
    const auto effect = decide_on(fixture.left == 2 ? award(number, 3, 0) : award(number, 0, 3));
    ASSERT_TRUE(effect) << effect.error().message;
    EXPECT_FALSE(effect->refused);
  }
  play(config);

  EXPECT_EQ(ranks(), (Names{"A", "C", "B"})) << "A climbs from rank 2";
  EXPECT_EQ(state().matches[3].fixture.left, 0);
  EXPECT_EQ(state().matches[3].fixture.right, 1);
}

TEST_F(DecisionsTest, PlayedMatchesAreDiscardedOnlyOnRequest) {
  const TournamentConfig config = ladder_of(3);
  play(config);
  const Names before = ranks();
  const auto effect = decide_on(decision_on(1, DecisionKind::kReplay));

  ASSERT_TRUE(effect);
  EXPECT_TRUE(effect->refused);
  EXPECT_EQ(effect->drawn_again, 4);
  EXPECT_EQ(effect->removed_played, 2);
  EXPECT_EQ(ranks(), before);
  EXPECT_TRUE(read_decisions(folder_.path())->empty());

  const auto again = decide_on(decision_on(1, DecisionKind::kReplay), true);
  ASSERT_TRUE(again);
  EXPECT_FALSE(again->refused);
  EXPECT_EQ(state().matches.size(), 3u);

  play(config);
  EXPECT_EQ(played().size(), 3u);
}

TEST_F(DecisionsTest, AnAnnulledStepOfALadderIsPlayedOff) {
  const TournamentConfig config = ladder_of(2);
  play(config);
  ASSERT_EQ(state().matches.size(), 2u);
  ASSERT_TRUE(decide_on(decision_on(2, DecisionKind::kAnnul)));
  play(config, [](const Fixture&) { return score(0, 2); });
  ASSERT_EQ(state().matches.size(), 3u);
  EXPECT_EQ(state().matches[2].fixture.stage, "finals, final");
  EXPECT_TRUE(state().matches[2].fixture.decides);
}

TEST_F(DecisionsTest, WrongDecisionsAreRefused) {
  const TournamentConfig config = ladder_of(2);
  play(config, better_wins, 0);
  const auto error = [&](const MatchDecision& decision) {
    const auto effect = decide_on(decision);
    return effect ? std::string() : effect.error().message;
  };

  EXPECT_EQ(error(award(9, 3, 0)), "no match 9: 1 match is scheduled so far");
  EXPECT_EQ(error(decision_on(1, DecisionKind::kReplay)), "match 1 was not played yet");
  EXPECT_EQ(error(decision_on(1, DecisionKind::kAsPlayed)), "match 1 counts as played already");

  play(config);
  EXPECT_EQ(error(award(2, 1, 1)), "match 2 must have a winner: award goals, or penalties too");
}

TEST_F(DecisionsTest, ACorruptFileIsNamedWithItsLine) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 2);
  play(config);
  ASSERT_TRUE(decide_on(decision_on(1, DecisionKind::kAnnul)));
  const std::filesystem::path file = folder_.path() / kDecisionsFile;
  std::ofstream(file, std::ios::app) << "{\"match\": 2, \"kind\": \"anul\"}\n";
  const auto read = read_tournament(folder_.path());
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message, file.string() + ":2: kind: unknown value 'anul'");
}

MatchDecision withdrawal(int team) {
  MatchDecision decision = decision_on(0, DecisionKind::kWithdraw);
  decision.teams = {team};
  return decision;
}

bool plays(const Assignment& one, int team) {
  return one.fixture.left == team || one.fixture.right == team;
}

TEST_F(DecisionsTest, ATeamThatLeavesIsNotPairedInLaterSwissRounds) {
  TournamentConfig config = config_of(Format::kSwiss, 4);
  config.competition.swap_sides = false;
  config.competition.rounds = 3;
  play(config, better_wins, 2);
  ASSERT_EQ(state().matches.size(), 4U) << "the second round is drawn";

  const auto effect = decide_on(withdrawal(0));
  ASSERT_TRUE(effect) << effect.error().message;
  EXPECT_EQ(effect->drawn_again, 3);
  play(config);
  EXPECT_EQ(played().size(), 2U) << "a match of the three that are left in each round";
  for (const Assignment& one : record_.started) EXPECT_FALSE(plays(one, 0));

  const TournamentState now = state();
  const auto all = byes(now.config.competition, now.matches);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NE(all[0].team, all[1].team);
  EXPECT_TRUE(all[0].team != 0 && all[1].team != 0);
  EXPECT_EQ(decide_on(withdrawal(0)).error().message, "A has withdrawn already");
}

// Byes go round when there are more rounds than teams that are left.
TEST_F(DecisionsTest, ThreeTeamsThatAreLeftHaveByesInTurn) {
  TournamentConfig config = config_of(Format::kSwiss, 6);
  config.competition.swap_sides = false;
  config.competition.rounds = 5;
  play(config, better_wins, 3);
  for (const int team : {0, 2, 4}) ASSERT_TRUE(decide_on(withdrawal(team)));
  play(config);

  const TournamentState now = state();
  std::map<int, int> times;
  for (const Bye& bye : byes(now.config.competition, now.matches)) ++times[bye.team];
  ASSERT_EQ(times.size(), 3U);
  int all = 0;
  for (const auto& [team, number] : times) {
    EXPECT_LE(number, 2) << team;
    all += number;
  }
  EXPECT_EQ(all, 4) << "rounds 2 to 5";
}

TEST_F(DecisionsTest, OpponentsOfATeamThatLeavesWinTheirMatches) {
  TournamentConfig config = config_of(Format::kRoundRobin, 3);
  play(config, better_wins, 4);
  const auto effect = decide_on(withdrawal(0));
  ASSERT_TRUE(effect);
  EXPECT_EQ(effect->awarded, 2) << "of four, two were played";
  play(config);
  EXPECT_TRUE(played().empty());

  const TournamentState now = state();
  for (const ScheduledMatch& match : now.matches) {
    ASSERT_TRUE(match.outcome);
    EXPECT_EQ(is_by_withdrawal(match), match.outcome->forfeit);
  }
  const Report report = make_report(now.config, now.matches, folder_.path());
  EXPECT_THAT(report_text(report, {}), testing::HasSubstr("withdrawn: A"));

  ASSERT_TRUE(decide_on(withdrawal(1)));
  EXPECT_EQ(count(state().matches).finished, 4) << "what was played counts";
}

TEST_F(DecisionsTest, AMatchOfTwoTeamsThatLeftCountsForNothing) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 3);
  play(config, better_wins, 0);
  for (const int team : {0, 1}) ASSERT_TRUE(decide_on(withdrawal(team)));
  play(config);
  EXPECT_TRUE(played().empty());

  const MatchCounts counts = count(state().matches);
  EXPECT_EQ(counts.annulled, 2) << "A against B, from both sides";
  EXPECT_EQ(counts.forfeits, 4);
  EXPECT_EQ(ranks().front(), "C");
}

TEST_F(DecisionsTest, TheNextTeamOfAGroupGoesOnForOneThatLeaves) {
  TournamentConfig config = config_of(Format::kGroups, 6);
  config.competition.swap_sides = false;
  config.competition.advance = 1;
  play(config, better_wins, 6);
  const int winner = state().matches[6].fixture.left;

  ASSERT_TRUE(decide_on(withdrawal(winner)));
  play(config);
  for (const Assignment& one : record_.started) EXPECT_FALSE(plays(one, winner));
  ASSERT_EQ(played().size(), 1U) << "a final";
}

TEST_F(DecisionsTest, AKnockoutGoesOnWithoutATeamThatLeaves) {
  TournamentConfig config = config_of(Format::kKnockout, 4);
  play(config, better_wins, 4);
  ASSERT_TRUE(decide_on(withdrawal(0)));
  play(config);

  const TournamentState now = state();
  EXPECT_TRUE(make_report(now.config, now.matches, folder_.path()).complete);
  EXPECT_EQ(ranks().front(), "B");
}

TEST_F(DecisionsTest, AStageBeginsWithoutATeamThatLeft) {
  TournamentConfig config = ladder_of(3);
  play(config, better_wins, 3);
  ASSERT_TRUE(decide_on(withdrawal(0)));
  play(config);
  for (const Assignment& one : record_.started) EXPECT_FALSE(plays(one, 0));
  EXPECT_TRUE(make_report(config, state().matches, folder_.path()).complete);
}

TEST_F(DecisionsTest, ADecisionOnAnUnknownTeamIsNamed) {
  const TournamentConfig config = config_of(Format::kRoundRobin, 3);
  play(config, better_wins, 2);
  ASSERT_TRUE(decide_on(withdrawal(0)));
  std::ofstream(folder_.path() / kDecisionsFile, std::ios::app)
      << R"({"match": 2, "kind": "withdraw", "teams": [7]})"
      << "\n";
  const auto read = read_tournament(folder_.path());
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, testing::HasSubstr("there is no team 7"));
}

// Teams that a lot would separate have the order of the organizers, and the next round follows it.
TEST_F(DecisionsTest, AnOrderStandsInPlaceOfALot) {
  TournamentConfig config = config_of(Format::kGroups, 6);
  config.competition.swap_sides = false;
  config.competition.advance = 1;
  const auto draws = [](const Fixture&) { return score(0, 0); };
  play(config, draws, 6);

  const TournamentState now = state();
  const auto equal = equal_teams(now.config.competition, now.matches);
  ASSERT_EQ(equal.size(), 2U);
  MatchDecision decision = decision_on(0, DecisionKind::kOrder);
  decision.teams = {equal[0].teams.rbegin(), equal[0].teams.rend()};
  const auto effect = decide_on(decision);
  ASSERT_TRUE(effect) << effect.error().message;

  const auto table = tables(now.config.competition, state().matches).front();
  EXPECT_EQ(table.standings.front().team, equal[0].teams.back());
  EXPECT_EQ(table.standings[1].separated_by, kDecision);
  play(config);
  ASSERT_FALSE(record_.started.empty());
  EXPECT_TRUE(plays(record_.started.front(), equal[0].teams.back()));

  decision.teams.pop_back();
  EXPECT_THAT(decide_on(decision).error().message,
              testing::HasSubstr("no lot separates these teams"));
}

// The board of 2024 lists 0-1 in the match for rank 3, and its loser as semi-finalist and third.
TEST_F(DecisionsTest, CorrectTheLadderOf2024) {
  const auto source = tests::fixture("tournament/robocup2024");
  const ParsedConfig parsed = read_config(source / "cls.toml");
  ASSERT_TRUE(parsed.errors.empty());

  const auto make = [&](const TournamentConfig& one) {
    return results_executor(one, source / "results.txt");
  };
  constexpr int kForRank3 = 145;  // 4 x 20 in groups, 58 in divisions, 7 of the ladder
  run_with(parsed.config, kForRank3, make);

  ASSERT_EQ(state().matches.size(), 146u);
  EXPECT_EQ(state().matches[144].fixture.stage, "final day, rank 3");

  const auto effect = decide_on(award(kForRank3, 1, 0));
  ASSERT_TRUE(effect) << effect.error().message;
  EXPECT_EQ(effect->drawn_again, 146) << "the file has no semi-final of FRA-UNIted";

  run_with(parsed.config, std::nullopt, make);
  EXPECT_EQ(ranks(), (Names{"HELIOS", "CYRUS", "YuShan", "FRA-UNIted", "R2D2", "RoboCIn", "Oxsy",
                            "AETeam", "ITAndroids", "Mars"}));

  const TournamentState now = state();
  const Report report = make_report(now.config, now.matches, folder_.path());
  const std::string text = report_text(report, {});
  EXPECT_NE(text.find("(2+4) - (2+3)"), std::string::npos) << text;
  EXPECT_NE(text.find("a protest"), std::string::npos) << text;
  EXPECT_TRUE(report.complete);
}

}  // namespace
}  // namespace cls::tournament
