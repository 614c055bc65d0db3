// The referee's words and what others say.
#include <gtest/gtest.h>

#include <string>

#include "proxy/perception.h"

namespace cls::proxy {
namespace {

using soccer::PlayMode;
using soccer::Side;

WorldModel model(Side side) {
  WorldModel world;
  on_init(world, {side, 4, PlayMode::kBeforeKickOff}, "Us", false);
  return world;
}

void sense(WorldModel& world, int time) {
  soccer::SenseBody sense;
  sense.time = time;
  on_sense_body(world, sense);
}

void referee(WorldModel& world, int time, const std::string& word) {
  soccer::Hear hear;
  hear.time = time;
  hear.text = word;
  on_hear(world, hear);
}

TEST(Hearing, ModesComeWithTheirMoment) {
  WorldModel world = model(Side::kLeft);
  sense(world, 0);
  sense(world, 0);
  sense(world, 0);
  EXPECT_EQ(world.game.time.stopped, 3);
  referee(world, 0, "kick_off_l");
  EXPECT_EQ(world.game.mode, PlayMode::kKickOffLeft);
  EXPECT_EQ(world.game.mode_start.cycle, 0);
  EXPECT_EQ(world.game.mode_start.stopped, 3);
  EXPECT_EQ(world.game.last_set_play_start, 0);
  complete(world);
  complete(world);
  EXPECT_EQ(world.game.set_play_count, 2);
  sense(world, 0);
  EXPECT_EQ(world.game.time.stopped, 0);
  sense(world, 1);
  EXPECT_EQ(world.game.time.stopped, 0);
  referee(world, 1, "play_on");
  EXPECT_EQ(world.game.mode, PlayMode::kPlayOn);
  EXPECT_EQ(world.game.last_set_play_start, 0);
  referee(world, 57, "kick_in_r");
  EXPECT_EQ(world.game.last_set_play_start, 57);
  EXPECT_EQ(world.game.set_play_count, 0);
  EXPECT_EQ(world.game.mode_start.cycle, 57);
  EXPECT_EQ(world.game.mode_start.stopped, 0);
}

TEST(Hearing, GoalsCountForTheSideThatScored) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    WorldModel world = model(side);
    referee(world, 100, "goal_l_2");
    EXPECT_EQ(world.game.mode, PlayMode::kGoalLeft);
    EXPECT_EQ(world.game.our_score, side == Side::kLeft ? 2 : 0);
    EXPECT_EQ(world.game.their_score, side == Side::kRight ? 2 : 0);
    referee(world, 300, "goal_r_11");
    EXPECT_EQ(side == Side::kLeft ? world.game.their_score : world.game.our_score, 11);
  }
}

TEST(Hearing, TheGoaliesFreeKickIsToldFromOthers) {
  WorldModel world = model(Side::kLeft);
  referee(world, 40, "goalie_catch_ball_r");
  referee(world, 40, "free_kick_r");
  EXPECT_TRUE(world.game.goalie_catch);
  EXPECT_EQ(world.game.mode, PlayMode::kFreeKickRight);
  referee(world, 90, "play_on");
  EXPECT_FALSE(world.game.goalie_catch);
  referee(world, 120, "free_kick_r");
  EXPECT_FALSE(world.game.goalie_catch);
}

TEST(Hearing, SetPlaysBelongToWhoeverMayPlayTheBall) {
  WorldModel world = model(Side::kLeft);
  const auto ours = [&] { return is_set_play_of(world.game, Side::kLeft); };
  const auto theirs = [&] { return is_set_play_of(world.game, Side::kRight); };
  referee(world, 1, "kick_in_l");
  EXPECT_TRUE(ours() && !theirs());
  referee(world, 2, "offside_l");
  EXPECT_TRUE(!ours() && theirs());
  referee(world, 3, "indirect_free_kick_r");
  EXPECT_TRUE(!ours() && theirs());
  referee(world, 4, "foul_charge_r");
  EXPECT_TRUE(ours() && !theirs());
  referee(world, 5, "play_on");
  EXPECT_TRUE(!ours() && !theirs());
  referee(world, 6, "goal_l_1");
  EXPECT_TRUE(!ours() && !theirs());
}

TEST(Hearing, TheShootOutIsCounted) {
  WorldModel world = model(Side::kRight);
  referee(world, 600, "penalty_onfield_r");
  referee(world, 600, "penalty_setup_l");
  referee(world, 670, "penalty_ready_l");
  referee(world, 675, "penalty_taken_l");
  referee(world, 700, "penalty_score_l");
  referee(world, 711, "penalty_setup_r");
  const PenaltyState& penalty = world.game.penalty;
  EXPECT_EQ(penalty.field_side, Side::kRight);
  EXPECT_EQ(penalty.taker, Side::kRight);
  EXPECT_EQ(penalty.our_taken, 1);
  EXPECT_EQ(penalty.their_taken, 1);
  EXPECT_EQ(penalty.our_score, 0);
  EXPECT_EQ(penalty.their_score, 1);
  EXPECT_EQ(penalty.cycle, 711);
  EXPECT_EQ(default_penalty_taker(penalty.our_taken), 10);
  EXPECT_EQ(default_penalty_taker(12), 10);
}

TEST(Hearing, OtherWordsOfTheRefereeChangeNothing) {
  WorldModel world = model(Side::kLeft);
  referee(world, 5, "play_on");
  for (const char* word : {"half_time", "time_extended", "time_up", "yellow_card_l_5", "foul_l",
                           "penalty_draw", "training Keepaway 1", "goal_", "goal_x_1", "", "x"}) {
    referee(world, 5, word);
    EXPECT_EQ(world.game.mode, PlayMode::kPlayOn) << word;
  }
}

TEST(Hearing, WhatPlayersSayIsKeptForTheMoment) {
  WorldModel world = model(Side::kLeft);
  sense(world, 8);
  soccer::Hear hear;
  hear.time = 8;
  hear.sender = soccer::Hear::Sender::kTeammate;
  hear.unum = 9;
  hear.direction = 30;
  hear.text = "PajQs9";
  on_hear(world, hear);
  hear.partial = true;
  on_hear(world, hear);
  ASSERT_EQ(world.heard.size(), 1U);
  EXPECT_EQ(world.heard[0].text, "PajQs9");
  EXPECT_EQ(world.heard[0].unum, 9);
  EXPECT_EQ(world.heard[0].side, Side::kLeft);
  EXPECT_NEAR(world.heard[0].direction.degrees(), 30.0, 1e-9);
  sense(world, 9);
  EXPECT_TRUE(world.heard.empty());
}

}  // namespace
}  // namespace cls::proxy
