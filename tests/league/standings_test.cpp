// Standings: points, goals, and tiebreakers.
#include "league/schedule/standings.h"

#include <gtest/gtest.h>

#include <set>

#include "league/schedule/formats.h"
#include "tests/league/made_up_results.h"

namespace cls::league {
namespace {

using soccer::EndReason;

ScheduledMatch match(int left, int right, Outcome outcome) {
  ScheduledMatch played;
  played.fixture.left = left;
  played.fixture.right = right;
  played.outcome = std::move(outcome);
  return played;
}

std::vector<int> order(const std::vector<Standing>& table) {
  std::vector<int> teams;
  for (const Standing& row : table) teams.push_back(row.team);
  return teams;
}

const std::vector<int> kFour = {0, 1, 2, 3};
const std::vector<TieBreaker> kLeague = tie_breakers_of(competition_of(Format::kRoundRobin, 4));

TEST(Standings, CountPointsAndGoals) {
  Outcome shoot_out = score(1, 1);
  shoot_out.left_penalties = 2;
  shoot_out.right_penalties = 3;

  const std::vector<ScheduledMatch> matches = {
      match(0, 1, score(3, 1)), match(1, 0, score(2, 2)), match(0, 1, shoot_out),
      match(0, 1, fault(EndReason::kCrashed)), planned({})};
  const auto table = standings(std::vector<int>{0, 1}, matches, kLeague);

  EXPECT_EQ(table[0].team, 0);
  EXPECT_EQ(table[0].points, 4);
  EXPECT_EQ(table[0].played, 3);
  EXPECT_EQ(table[0].won, 1);
  EXPECT_EQ(table[0].drawn, 1);
  EXPECT_EQ(table[0].lost, 1) << "on penalties";
  EXPECT_EQ(table[0].goals_for, 6);
  EXPECT_EQ(table[0].goals_against, 4);
  EXPECT_EQ(table[0].invalid, 1);
  EXPECT_EQ(table[1].points, 4);
  EXPECT_EQ(table[1].separated_by, "goal-difference") << "three points each against each other";
}

TEST(Standings, CountForfeits) {
  Outcome forfeit = fault(EndReason::kCrashed);
  forfeit.forfeit = true;
  forfeit.right_score = 3;
  const auto table = standings(std::vector<int>{0, 1}, std::vector{match(0, 1, forfeit)}, kLeague);
  EXPECT_EQ(table[0].team, 1);
  EXPECT_EQ(table[0].points, 3);
  EXPECT_EQ(table[0].goals_for, 3);
}

TEST(Standings, RankWinnerOfTheirMatchFirstOfTwo) {
  // 0 and 1 have six points each; 1 has by far more goals, 0 has beaten 1.
  const std::vector<ScheduledMatch> matches = {match(0, 1, score(1, 0)), match(0, 2, score(1, 0)),
                                               match(0, 3, score(0, 1)), match(1, 2, score(9, 0)),
                                               match(1, 3, score(9, 0)), match(2, 3, score(0, 0))};
  const auto table = standings(kFour, matches, kLeague);
  EXPECT_EQ(order(table), (std::vector<int>{0, 1, 3, 2}));
  EXPECT_EQ(table[1].separated_by, "head-to-head");
  EXPECT_EQ(table[2].separated_by, "");
}

TEST(Standings, RestartTieBreakersAfterGoalDifferenceSeparatesThree) {
  // 0, 1, 2 beat each other in a circle and all beat 3. Differences: 0: +5, 1: +1, 2: +1.
  const std::vector<ScheduledMatch> matches = {match(0, 1, score(1, 0)), match(1, 2, score(1, 0)),
                                               match(2, 0, score(1, 0)), match(0, 3, score(5, 0)),
                                               match(1, 3, score(1, 0)), match(2, 3, score(1, 0))};
  const auto table = standings(kFour, matches, kLeague);
  EXPECT_EQ(order(table), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(table[1].separated_by, "goal-difference");
  EXPECT_EQ(table[2].separated_by, "head-to-head") << "of the two that are left, 1 beat 2";
}

TEST(Standings, RankTeamThatBeatAllOthersFirst) {
  const std::vector<ScheduledMatch> matches = {match(1, 0, score(1, 0)), match(1, 2, score(1, 0)),
                                               match(3, 1, score(1, 0)), match(0, 2, score(4, 0)),
                                               match(0, 3, score(4, 0)), match(2, 3, score(1, 0))};
  // 1 and 0 have six points, 2 and 3 three; 1 beat 0 and 2 beat 3.
  EXPECT_EQ(order(standings(kFour, matches, kLeague)), (std::vector<int>{1, 0, 2, 3}));
}

TEST(Standings, CompareGoalsAmongTiedTeamsAfterAllGoals) {
  // A circle of 0, 1, 2 with the same differences; more goals in all decide, then goals among them.
  const std::vector<ScheduledMatch> matches = {match(0, 1, score(2, 1)), match(1, 2, score(2, 1)),
                                               match(2, 0, score(2, 1)), match(0, 3, score(1, 0)),
                                               match(1, 3, score(2, 1)), match(2, 3, score(3, 2))};
  EXPECT_EQ(order(standings(kFour, matches, kLeague)), (std::vector<int>{2, 1, 0, 3}));
}

TEST(Standings, ShareRankWithoutSeparatingTieBreaker) {
  const auto table = standings(kFour, std::vector{match(0, 1, score(1, 1))}, kLeague);
  EXPECT_EQ(order(table), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(table[0].rank, 1);
  EXPECT_EQ(table[1].rank, 1);
  EXPECT_EQ(table[2].rank, 3);
}

TEST(Standings, CountPointsPerMatchWhenMatchesAreMissing) {
  const std::vector<ScheduledMatch> matches = {match(0, 3, score(1, 0)), match(1, 3, score(1, 0)),
                                               match(1, 2, score(1, 1))};
  EXPECT_EQ(order(standings(kFour, matches, kLeague)), (std::vector<int>{0, 1, 2, 3}));
}

TEST(Standings, ComputeBuchholzAndSonnebornBerger) {
  // 0 beats 1 and draws with 2; 1 beats 3; 2 beats 3.
  const std::vector<ScheduledMatch> matches = {match(0, 1, score(1, 0)), match(0, 2, score(1, 1)),
                                               match(1, 3, score(1, 0)), match(2, 3, score(1, 0))};
  for (const Standing& row : standings(kFour, matches, {})) {
    if (row.team != 0) continue;
    EXPECT_EQ(row.buchholz, 3.0 + 4.0);
    EXPECT_EQ(row.sonneborn_berger, 3.0 + 4.0 / 2);
  }
  const std::vector<Bye> byes = {{3, 2}};
  const auto table = standings(kFour, matches, {}, byes);

  EXPECT_EQ(table[0].team, 0);

  for (const Standing& row : table) {
    if (row.team == 3) {
      EXPECT_EQ(row.points, 6);
      EXPECT_EQ(row.byes, 1);
    }
  }
}

TEST(Standings, UseConfiguredTieBreakers) {
  const std::vector<ScheduledMatch> matches = {match(0, 1, score(1, 0)), match(1, 0, score(5, 4)),
                                               match(0, 2, score(0, 0)), match(1, 2, score(3, 3))};
  const std::vector<int> teams = {0, 1, 2};
  EXPECT_EQ(order(standings(teams, matches, {TieBreaker::kGoals})), (std::vector<int>{1, 0, 2}));
}

// Who goes on does not depend on the order of teams in a file.
TEST(DrawLots, OrdersEqualTeamsOfThePlacesThatGoOn) {
  const std::vector<ScheduledMatch> matches = {match(0, 1, score(1, 0)), match(1, 2, score(1, 0)),
                                               match(2, 0, score(1, 0))};
  const auto table = standings(std::vector<int>{0, 1, 2}, matches, kLeague);
  ASSERT_EQ(table[2].rank, 1);
  const auto drawn = [&](std::uint64_t seed, std::string_view title, int places) {
    auto result = table;
    draw_lots(seed, title, places, {}, result);
    return result;
  };

  const auto once = drawn(1, "group A", 2);
  EXPECT_EQ(order(once), order(drawn(1, "group A", 2)));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(once[i].rank, static_cast<int>(i) + 1);
  EXPECT_EQ(once[0].separated_by, "");
  EXPECT_EQ(once[1].separated_by, kLot);

  std::set<int> first;
  std::set<std::vector<int>> of_titles;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    first.insert(drawn(seed, "group A", 1)[0].team);
    of_titles.insert(order(drawn(1, "group " + std::to_string(seed), 1)));
  }
  EXPECT_EQ(first.size(), 3U);
  EXPECT_EQ(of_titles.size(), 6U);
  EXPECT_EQ(drawn(1, "group A", 0)[2].rank, 1) << "nobody goes on";
}

}  // namespace
}  // namespace cls::league
