// SPADL actions of scripted matches, and what socceraction demands of their table.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "analysis/results/periods.h"
#include "analysis/statistics/spadl_actions.h"
#include "tests/analysis/plays.h"
#include "tests/gamelog/recorded_match.h"

namespace cls::analysis {
namespace {

using soccer::PlayMode;
using soccer::Vec2;
using testing::ElementsAre;
using testing::HasSubstr;
using tests::left;
using tests::right;
using tests::ScriptedMatch;

std::string text_of(const SpadlAction& action) {
  return fmt::format("{}{} {} {}", action.slot < 11 ? "l" : "r", soccer::unum_of_slot(action.slot),
                     name(action.type), name(action.result));
}

std::vector<SpadlAction> actions_of(const ScriptedMatch& match) {
  return spadl_actions(compute_statistics(match.record(), nullptr));
}

std::vector<std::string> texts_of(const ScriptedMatch& match) {
  std::vector<std::string> texts;
  for (const SpadlAction& action : actions_of(match)) texts.push_back(text_of(action));
  return texts;
}

// A match in which left 5 restarts play by `mode` and passes to left 6.
ScriptedMatch restart(PlayMode mode) {
  ScriptedMatch match;
  match.mode(mode);
  match.steps(2);
  match.mode(PlayMode::kPlayOn);
  match.kick(left(5), {1, 0});
  match.kick(left(6), {0.1, 0});
  return match;
}

TEST(Spadl, NamesPassesByTheirRestart) {
  for (const auto& [mode, type] : {std::pair(PlayMode::kPlayOn, "pass"),
                                   {PlayMode::kKickInLeft, "throw_in"},
                                   {PlayMode::kCornerKickLeft, "corner_short"},
                                   {PlayMode::kFreeKickLeft, "freekick_short"},
                                   {PlayMode::kIndirectFreeKickLeft, "freekick_short"},
                                   {PlayMode::kGoalKickLeft, "goalkick"},
                                   {PlayMode::kKickOffLeft, "pass"}}) {
    EXPECT_THAT(texts_of(restart(mode)), ElementsAre(fmt::format("l5 {} success", type)));
  }
}

TEST(Spadl, PlacesActionsOnThePitchOfTheLeftTeam) {
  ScriptedMatch match;
  kick_from(match, {-10, 20}, right(5), {-2, 0});
  match.kick(right(6), {0.1, 0});
  const std::vector<SpadlAction> actions = actions_of(match);
  ASSERT_EQ(actions.size(), 1u);
  EXPECT_EQ(actions[0].start, (Vec2{42.5, 14.0}));
  EXPECT_EQ(actions[0].end, (Vec2{40.5, 14.0}));
  EXPECT_EQ(actions[0].event, 0u);
}

TEST(Spadl, AddsTheInterceptionOfALostPass) {
  ScriptedMatch match;
  match.kick(left(5), {1, 0});
  match.kick(right(8), {0.1, 0});
  const std::vector<SpadlAction> actions = actions_of(match);
  ASSERT_EQ(actions.size(), 2u);
  EXPECT_EQ(text_of(actions[0]), "l5 pass fail");
  EXPECT_EQ(text_of(actions[1]), "r8 interception success");
  EXPECT_EQ(actions[1].start, (Vec2{53.5, 34.0}));
  EXPECT_EQ(actions[1].start, actions[1].end);
  EXPECT_FALSE(actions[1].event);
}

TEST(Spadl, GoaliesPickUpPassesAndSaveShots) {
  ScriptedMatch match;
  kick_from(match, {40, 0}, left(9), {2.7, 0});
  match.steps(2);
  catch_ball(match, right(1));
  match.step();

  EXPECT_THAT(texts_of(match), ElementsAre("l9 shot fail", "r1 keeper_save success"));
  EXPECT_EQ(actions_of(match)[1].body_part, SpadlBodyPart::kOther);

  ScriptedMatch pass;
  pass.kick(left(5), {0, 1});
  catch_ball(pass, right(1));
  pass.step();

  EXPECT_THAT(texts_of(pass), ElementsAre("l5 pass fail", "r1 keeper_pick_up success"));
}

TEST(Spadl, TacklesSucceedIfTheTeamKeepsTheBall) {
  const auto after_tackle = [](int slot) {
    ScriptedMatch match;
    match.kick(left(5), {0.3, 0});
    match.tackle(right(7), {-0.1, 0});
    match.kick(slot, {0.1, 0});
    return texts_of(match);
  };
  EXPECT_EQ(after_tackle(right(8)).at(0), "r7 tackle success");
  EXPECT_EQ(after_tackle(left(8)).at(0), "r7 tackle fail");
}

TEST(Spadl, FoulsHaveTheirCards) {
  const auto foul = [](std::uint32_t card) {
    ScriptedMatch match;
    miss_ball(match, left(4));
    match.step();
    match.mode(PlayMode::kFoulChargeLeft);
    match.player(left(4)).state |= card;
    match.steps(3);
    return texts_of(match);
  };
  EXPECT_THAT(foul(0), ElementsAre("l4 foul fail"));
  EXPECT_THAT(foul(gamelog::kStateYellowCard), ElementsAre("l4 foul yellow_card"));
  EXPECT_THAT(foul(gamelog::kStateRedCard), ElementsAre("l4 foul red_card"));
}

TEST(Spadl, OwnGoalsAreBadTouches) {
  ScriptedMatch match;
  kick_from(match, {-50, 0}, left(2), {-2.5, 0});
  match.step();
  score_goal(match, soccer::Side::kRight);
  EXPECT_THAT(texts_of(match), testing::Contains("l2 bad_touch owngoal"));
}

std::string table_of(const ScriptedMatch& match) {
  MatchSummary summary = summarize(match.record(), nullptr);
  summary.file = "m.rcg";
  base::Table table = spadl_table();
  add_spadl(summary, compute_statistics(match.record(), nullptr), table);
  return table.format_csv();
}

TEST(Spadl, TableHasTheColumnsOfSocceraction) {
  EXPECT_EQ(table_of(restart(PlayMode::kPlayOn)),
            "game_id,original_event_id,action_id,period_id,time_seconds,team_id,player_id,start_x,"
            "start_y,end_x,end_y,type_id,type_name,result_id,result_name,bodypart_id,"
            "bodypart_name\n"
            "m.rcg,0,0,1,0.4,A,A_5,52.5,34,53.5,34,0,pass,1,success,0,foot\n");
}

TEST(Spadl, SidesNameTeamsOfOneName) {
  ScriptedMatch match;
  match.next().teams[1].name = "A";
  match.kick(right(5), {-1, 0});
  match.kick(right(6), {0.1, 0});
  EXPECT_THAT(table_of(match), HasSubstr(",right,right_5,"));
}

TEST(Spadl, SecondsBeginWithEachPeriod) {
  ScriptedMatch match;
  match.record().server.half_time = 1;
  match.record().server.extra_half_time = 1;
  match.steps(9);  // the clock shows 10, the end of the first half
  match.kick(left(5), {1, 0});
  match.kick(left(6), {0.1, 0});
  EXPECT_THAT(table_of(match), HasSubstr("m.rcg,0,0,2,0.1,"));
}

TEST(Periods, AreHalvesExtraHalvesAndTheShootOut) {
  ScriptedMatch match;
  match.record().server.half_time = 1;
  match.record().server.extra_half_time = 2;
  match.steps(59);
  match.mode(PlayMode::kPenaltySetupLeft);
  match.steps(2);
  const std::vector<Period> periods = find_periods(match.record());

  ASSERT_EQ(periods.size(), 5u);
  EXPECT_EQ(periods[0].end_frame, 10u);
  EXPECT_EQ(periods[1].kind, PeriodKind::kSecondHalf);
  EXPECT_EQ(periods[1].start_cycle, 10);
  EXPECT_EQ(periods[2].kind, PeriodKind::kFirstExtraHalf);
  EXPECT_EQ(periods[2].start_cycle, 20);
  EXPECT_EQ(periods[3].start_cycle, 40);
  EXPECT_EQ(periods[4].kind, PeriodKind::kShootOut);
  EXPECT_EQ(periods[4].end_frame, match.record().frames());
  EXPECT_EQ(period_of(periods, 9).kind, PeriodKind::kFirstHalf);
  EXPECT_EQ(period_of(periods, 10).kind, PeriodKind::kSecondHalf);
}

TEST(Periods, OneWithoutALimitOfTime) {
  ScriptedMatch match;
  match.record().server.half_time = -1;
  match.steps(50);
  EXPECT_EQ(find_periods(match.record()).size(), 1u);
  EXPECT_TRUE(find_periods({}).empty());
}

// The schema of socceraction: identifiers within their lists, places within the pitch.
TEST(Spadl, RecordedMatchesFitTheSchema) {
  for (const char* name : {"match-start", "../simulator/noise-free"}) {
    SCOPED_TRACE(name);
    const gamelog::MatchRecord record = tests::record_of(name);
    const std::vector<SpadlAction> actions = spadl_actions(compute_statistics(record, nullptr));

    EXPECT_GT(actions.size(), 5u);

    std::uint32_t frame = 0;
    for (const SpadlAction& action : actions) {
      EXPECT_LT(static_cast<int>(action.type), 23);
      EXPECT_GE(action.slot, 0);
      EXPECT_GE(action.frame, frame);
      frame = action.frame;
      for (const Vec2 point : {action.start, action.end}) {
        EXPECT_TRUE(point.x >= 0 && point.x <= 105 && point.y >= 0 && point.y <= 68);
      }
    }
  }
}

}  // namespace
}  // namespace cls::analysis
