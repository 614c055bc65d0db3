// Results of scripted matches, and of rcssserver matches compared with other sources.
#include "analysis/results/match_summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "analysis/results/team_table.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcl/rcl_reader.h"
#include "tests/analysis/plays.h"
#include "tests/support/files.h"

namespace cls::analysis {
namespace {

using soccer::PlayMode;
using soccer::Side;
using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using tests::left;
using tests::right;
using tests::ScriptedMatch;

void end(ScriptedMatch& match) {
  match.mode(PlayMode::kTimeOver);
  match.step();
}

TEST(MatchSummary, ReportsScoreWinnerAndCompleteness) {
  ScriptedMatch match;
  match.score(2, 1);
  match.steps(3);
  EXPECT_FALSE(summarize(match.record(), nullptr).complete);
  EXPECT_EQ(summarize(match.record(), nullptr).winner, Winner::kNone);

  end(match);
  const MatchSummary summary = summarize(match.record(), nullptr);
  EXPECT_TRUE(summary.complete);
  EXPECT_EQ(summary.teams[0].name, "A");
  EXPECT_EQ(summary.teams[1].score, 1);
  EXPECT_EQ(summary.winner, Winner::kLeft);
  EXPECT_EQ(summary.frames, 5);
  EXPECT_EQ(summary.cycles, 4);
  EXPECT_EQ(summary.version, "6");
}

TEST(MatchSummary, TakesHalfTimeScoreFromLastFrameOfHalf) {
  ScriptedMatch match;
  match.record().server.half_time = 1;  // ten cycles
  match.score(1, 0);
  match.steps(5);
  match.score(1, 3);
  match.steps(10);
  end(match);
  const MatchSummary summary = summarize(match.record(), nullptr);

  EXPECT_EQ(summary.teams[0].first_half, 1);
  EXPECT_EQ(summary.teams[1].first_half, 3);

  match.score(9, 9);
  end(match);
  EXPECT_EQ(summarize(match.record(), nullptr).teams[0].first_half, 1);
}

TEST(MatchSummary, DecidesLevelMatchByShootOutThenCoin) {
  ScriptedMatch match;
  match.next().teams[0].penalty_scored = 2;
  match.next().teams[0].penalty_missed = 2;
  match.next().teams[1].penalty_scored = 4;
  end(match);
  const MatchSummary decided = summarize(match.record(), nullptr);

  EXPECT_TRUE(decided.penalties);
  EXPECT_EQ(decided.winner, Winner::kRight);

  match.next().teams[1].penalty_scored = 2;
  end(match);
  EXPECT_EQ(summarize(match.record(), nullptr).winner, Winner::kDraw);

  const gamelog::RclRecord text =
      text_log("6000,0\t(referee penalty_winner_l)\n6000,0\t(referee time_over)\n");
  const MatchSummary tossed = summarize(match.record(), &text);

  EXPECT_TRUE(tossed.coin_toss);
  EXPECT_EQ(tossed.winner, Winner::kLeft);
}

TEST(MatchSummary, ReportsCardsSubstitutionsAndDisconnections) {
  ScriptedMatch match;
  match.player(left(11)).state = 0;  // from the second frame
  match.player(right(4)).state = 0;
  match.steps(2);
  match.player(left(11)).state = gamelog::kStateEnabled;
  match.player(right(2)).state |= gamelog::kStateYellowCard;
  match.player(right(3)).type = 7;
  match.step();
  match.player(right(2)).state = gamelog::kStateRedCard;
  match.step();
  end(match);
  const MatchSummary summary = summarize(match.record(), nullptr);

  EXPECT_THAT(summary.cards,
              ElementsAre(AllOf(Field(&CardSummary::cycle, 4), Field(&CardSummary::unum, 2),
                                Field(&CardSummary::red, false)),
                          Field(&CardSummary::red, true)));
  ASSERT_EQ(summary.substitutions.size(), 1u);
  EXPECT_EQ(summary.substitutions[0].side, Side::kRight);
  EXPECT_EQ(summary.substitutions[0].unum, 3);
  EXPECT_EQ(summary.substitutions[0].to_type, 7);
  // A red card is not a disconnection.
  EXPECT_THAT(summary.disconnections,
              ElementsAre(Field(&PlayerEvent::unum, 11), Field(&PlayerEvent::unum, 4)));
  EXPECT_THAT(summary.reconnections, ElementsAre(Field(&PlayerEvent::cycle, 4)));
  EXPECT_TRUE(summary.late_starts.empty());
}

TEST(MatchSummary, ReportsLateAndMissingPlayers) {
  ScriptedMatch match;
  gamelog::MatchRecord record = match.record();  // one frame; two players are missing
  gamelog::RecordBuilder builder(record);
  record.players.state[5] = 0;
  record.players.state[6] = 0;
  gamelog::Frame frame = gamelog::frame_at(match.record(), 0);
  frame.time = 2;
  frame.players[6].state = 0;
  builder.append_frame(frame);
  const MatchSummary summary = summarize(record, nullptr);

  EXPECT_THAT(summary.late_starts,
              ElementsAre(AllOf(Field(&PlayerEvent::unum, 6), Field(&PlayerEvent::cycle, 2))));
  EXPECT_THAT(summary.never_connected, ElementsAre(Field(&PlayerEvent::unum, 7)));
}

TEST(MatchSummary, SummarizesTextLogAlone) {
  const MatchSummary summary = summarize(text_log(
      "0,0\tRecv A_b_1: (init A_b (version 18))\n0,0\tRecv B_Coach: (init B (version 18))\n"
      "169,0\t(referee goal_l_1)\n300,0\t(referee half_time)\n400,3\t(referee yellow_card_r_5)\n"
      "400,3\t(referee red_card_r_5)\n450,0\t(referee goal_r_1)\n500,0\t(referee goal_r_2)\n"
      "600,0\t(referee time_over)\n"));

  EXPECT_EQ(summary.version, "rcl");
  EXPECT_EQ(summary.teams[0].name, "A_b");
  EXPECT_EQ(summary.teams[0].score, 1);
  EXPECT_EQ(summary.teams[0].first_half, 1);
  EXPECT_EQ(summary.teams[1].score, 2);
  EXPECT_EQ(summary.winner, Winner::kRight);
  ASSERT_EQ(summary.goals.size(), 3u);
  EXPECT_EQ(summary.goals[2].cycle, 500);
  EXPECT_EQ(summary.goals[2].unum, 0);
  ASSERT_EQ(summary.cards.size(), 2u);
  EXPECT_TRUE(summary.cards[1].red);
  EXPECT_TRUE(summary.complete);
}

// The last line of rcssserver's result file: names, scores and penalties.
std::string csv_result(const std::string& name) {
  std::ifstream file(*tests::data("logs/" + name + ".csv"));
  std::string line;
  std::string last;
  while (std::getline(file, line)) last = line;
  return last.substr(last.find(", ") + 2);
}

std::string as_csv_result(const MatchSummary& summary) {
  const auto& [l, r] = summary.teams;
  std::string text = "\"" + l.name + "\", \"" + r.name + "\", NULL, NULL, " +
                     std::to_string(l.score) + ", " + std::to_string(r.score);
  if (!summary.penalties) return text + ", NULL, NULL, NULL, NULL, NULL";
  for (const int number : {l.penalty_score + l.penalty_missed, r.penalty_score + r.penalty_missed,
                           l.penalty_score, r.penalty_score}) {
    text += ", " + std::to_string(number);
  }
  return text + ", NULL";
}

TEST(MatchSummary, MatchesRcssserverResultFileAndTextLog) {
  for (const char* name :
       {"helios-vs-helios-full", "cyrus-vs-helios-full", "extra-time-and-penalties"}) {
    const auto game = tests::data("logs/" + std::string(name) + ".rcg.gz");
    if (!game) GTEST_SKIP() << "no data: set CLS_DATA";
    SCOPED_TRACE(name);
    const auto record = gamelog::read_rcg_file(game->string());
    const auto text =
        gamelog::read_rcl_file(tests::data("logs/" + std::string(name) + ".rcl.gz")->string());

    ASSERT_TRUE(record && text);

    const MatchSummary summary = summarize(*record, &*text);
    EXPECT_EQ(as_csv_result(summary), csv_result(name));

    const MatchSummary from_text = summarize(*text);
    EXPECT_EQ(from_text.winner, summary.winner);
    ASSERT_EQ(from_text.goals.size(), summary.goals.size());

    for (std::size_t i = 0; i < summary.goals.size(); ++i) {
      EXPECT_EQ(from_text.goals[i].cycle, summary.goals[i].cycle);
      EXPECT_EQ(from_text.goals[i].side, summary.goals[i].side);
    }

    ASSERT_EQ(from_text.cards.size(), summary.cards.size());

    for (std::size_t i = 0; i < summary.cards.size(); ++i) {
      EXPECT_EQ(from_text.cards[i].unum, summary.cards[i].unum);
    }

    EXPECT_TRUE(summary.disconnections.empty());
  }
}

MatchSummary result(const char* left_name, int left_score, const char* right_name, int right_score,
                    Winner winner) {
  MatchSummary match;
  match.teams = {TeamSummary{left_name, left_score}, TeamSummary{right_name, right_score}};
  match.winner = winner;
  return match;
}

TEST(TeamTable, SumsAndSortsResults) {
  const TeamTable standings = team_table({
      result("A", 3, "B", 1, Winner::kLeft),
      result("B", 0, "C", 0, Winner::kDraw),
      result("C", 2, "A", 2, Winner::kLeft),  // after a shoot-out
      result("A", 5, "B", 0, Winner::kNone),
      result("A", 5, "", 0, Winner::kLeft),
  });

  EXPECT_EQ(standings.not_counted, 2);
  ASSERT_EQ(standings.rows.size(), 3u);
  EXPECT_EQ(standings.rows[0].team, "C");
  EXPECT_EQ(standings.rows[0].points, 4);
  EXPECT_EQ(standings.rows[0].drawn, 1);
  EXPECT_EQ(standings.rows[1].team, "A");
  EXPECT_EQ(standings.rows[1].goals_for, 5);
  EXPECT_EQ(standings.rows[1].goals_against, 3);
  EXPECT_EQ(standings.rows[1].lost, 1);
  EXPECT_EQ(standings.rows[2].goal_difference(), -2);
}

// A corrupt log may contain any score.
TEST(TeamTable, SumsScoresBeyondInt) {
  constexpr int kMax = std::numeric_limits<int>::max();
  constexpr int kMin = std::numeric_limits<int>::min();
  const TeamTable standings = team_table({
      result("A", kMax, "B", kMin, Winner::kLeft),
      result("A", kMax, "B", kMin, Winner::kLeft),
  });
  ASSERT_EQ(standings.rows.size(), 2u);
  EXPECT_EQ(standings.rows[0].goals_for, 2LL * kMax);
  EXPECT_EQ(standings.rows[0].goal_difference(), 2LL * kMax - 2LL * kMin);
  EXPECT_EQ(standings.rows[1].goal_difference(), 2LL * kMin - 2LL * kMax);
}

}  // namespace
}  // namespace cls::analysis
