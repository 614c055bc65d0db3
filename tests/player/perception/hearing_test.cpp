// Referee messages and say messages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "player/perception/perception.h"
#include "player/perception/say_message.h"

namespace cls::player {
namespace {

using testing::Each;
using testing::ElementsAre;

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

/// A say message of a teammate, without its text.
soccer::Hear said_by(int unum, int time) {
  soccer::Hear hear;
  hear.time = time;
  hear.sender = soccer::Hear::Sender::kTeammate;
  hear.unum = unum;
  return hear;
}

TEST(Hearing, RecordsModeWithGameTime) {
  WorldModel world = model(Side::kLeft);
  for (int i = 0; i < 3; ++i) sense(world, 0);
  EXPECT_EQ(world.game.time.stopped, 3);

  referee(world, 0, "kick_off_l");
  EXPECT_EQ(world.game.mode, PlayMode::kKickOffLeft);
  EXPECT_EQ(world.game.mode_start, (GameTime{0, 3}));
  EXPECT_EQ(world.game.last_set_play_start, 0);
  update_derived(world);
  update_derived(world);
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
  EXPECT_EQ(world.game.mode_start, (GameTime{57, 0}));
}

TEST(Hearing, CountsGoalsForScoringSide) {
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

TEST(Hearing, DistinguishesGoalieFreeKick) {
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

TEST(Hearing, AssignsSetPlayToTeamThatMayKick) {
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

TEST(Hearing, CountsShootOut) {
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
  EXPECT_THAT((std::array{penalty.our_taken, penalty.their_taken}), Each(1));
  EXPECT_THAT((std::array{penalty.our_score, penalty.their_score}), ElementsAre(0, 1));
  EXPECT_EQ(penalty.cycle, 711);
  EXPECT_EQ(default_penalty_taker(penalty.our_taken), 10);
  EXPECT_EQ(default_penalty_taker(12), 10);
}

TEST(Hearing, IgnoresOtherRefereeMessages) {
  WorldModel world = model(Side::kLeft);
  referee(world, 5, "play_on");
  for (const char* word : {"half_time", "time_extended", "time_up", "yellow_card_l_5", "foul_l",
                           "penalty_draw", "training Keepaway 1", "goal_", "goal_x_1", "", "x"}) {
    referee(world, 5, word);
    EXPECT_EQ(world.game.mode, PlayMode::kPlayOn) << word;
  }
}

TEST(Hearing, StoresSayMessagesForCurrentStep) {
  WorldModel world = model(Side::kLeft);
  sense(world, 8);
  soccer::Hear hear = said_by(9, 8);
  hear.direction = 30;
  hear.text = "some text";
  on_hear(world, hear);

  hear.partial = true;
  on_hear(world, hear);
  ASSERT_EQ(world.heard.size(), 1U);
  EXPECT_EQ(world.heard[0].text, "some text");
  EXPECT_EQ(world.heard[0].unum, 9);
  EXPECT_EQ(world.heard[0].side, Side::kLeft);
  EXPECT_NEAR(world.heard[0].direction.degrees(), 30.0, 1e-9);
  sense(world, 9);
  EXPECT_TRUE(world.heard.empty());
}

/// Delivers a say message of teammate `unum`.
void say(WorldModel& world, int unum, const SayMessage& message) {
  soccer::Hear hear = said_by(unum, world.game.time.cycle);
  ASSERT_TRUE(append_say_message(message, world.server(), hear.text));
  on_hear(world, hear);
}

SayPlayers one_player(const SaidPlayer& player) {
  SayPlayers message;
  message.players.push_back(player);
  return message;
}

/// Adds an opponent seen `age` cycles ago; returns its id.
int add_opponent(WorldModel& world, int unum, Vec2 position, int age) {
  PlayerState player;
  player.id = world.next_player_id++;
  player.side = world.their_side();
  player.unum = unum;
  player.position = position;
  player.pos_count = player.seen_pos_count = age;
  player.unum_count = unum == 0 ? kNever : age;
  player.covariance[0] = player.covariance[5] = 0.25;
  world.opponents.push_back(player);
  return player.id;
}

TEST(HeardSayMessages, SetUnseenBall) {
  WorldModel world = model(Side::kRight);
  sense(world, 8);
  say(world, 9, SayBall{{10.0, -5.0}, {0.5, 1.0}});
  const BallState& ball = world.ball;
  EXPECT_LT(soccer::distance(ball.position, {10.0, -5.0}), 0.1);
  EXPECT_LT(soccer::distance(ball.velocity, {0.5, 1.0}), 0.1);
  EXPECT_THAT((std::array{ball.pos_count, ball.vel_count}), Each(1));
  EXPECT_THAT((std::array{ball.heard_pos_count, ball.heard_vel_count}), Each(0));
  EXPECT_EQ(ball.seen_pos_count, kNever);

  sense(world, 9);
  EXPECT_EQ(ball.heard_pos_count, 1);
  EXPECT_EQ(ball.pos_count, 2);
  EXPECT_LT(soccer::distance(ball.heard_position, {10.0, -5.0}), 0.1);
  EXPECT_LT(soccer::distance(ball.position, {10.5, -4.0}), 0.15);  // after rolling
}

TEST(HeardSayMessages, AddUnseenPlayersWithNumbers) {
  WorldModel world = model(Side::kLeft);
  sense(world, 8);
  SayPlayers players;
  players.players.push_back({9, {20.0, 10.0}});
  players.players.push_back({14, {-30.0, -10.0}});
  players.players.push_back({4, {1.0, 1.0}});  // the agent itself
  say(world, 2, players);

  ASSERT_NE(world.teammate(9), nullptr);
  ASSERT_NE(world.opponent(3), nullptr);
  EXPECT_EQ(world.teammate(4), nullptr);
  EXPECT_LT(soccer::distance(world.teammate(9)->position, {20.0, 10.0}), 0.5);
  EXPECT_EQ(world.teammate(9)->pos_count, 1);
  EXPECT_EQ(world.teammate(9)->heard_pos_count, 0);
  EXPECT_EQ(world.teammate(9)->unum_count, kNever);
}

TEST(HeardSayMessages, NumberUnnumberedTrack) {
  WorldModel world = model(Side::kLeft);
  sense(world, 8);
  const int id = add_opponent(world, 0, {30.0, 5.0}, 0);
  add_opponent(world, 0, {30.0, -5.0}, 0);
  const SayPlayers players = one_player({11 + 6, {30.4, 5.3}});
  say(world, 2, players);
  ASSERT_NE(world.opponent(6), nullptr);
  EXPECT_EQ(world.opponent(6)->id, id);
  EXPECT_EQ(world.opponent(6)->position,
            (Vec2{30.0, 5.0}));  // the current see message takes precedence
  EXPECT_EQ(world.opponents.size(), 2U);
}

TEST(HeardSayMessages, DoNotOverrideRecentlySeenNumber) {
  WorldModel world = model(Side::kLeft);
  sense(world, 8);
  add_opponent(world, 6, {30.0, 5.0}, 2);
  add_opponent(world, 0, {30.0, -5.0}, 2);
  const SayPlayers players = one_player({11 + 6, {30.0, -5.0}});
  say(world, 2, players);
  EXPECT_GT(world.opponent(6)->position.y, 0.0);
  for (PlayerState& player : world.opponents) player.unum_count += 100;
  say(world, 2, players);
  EXPECT_LT(world.opponent(6)->position.y, 0.0);
}

TEST(HeardSayMessages, IgnoreInvalidText) {
  WorldModel world = model(Side::kLeft);
  sense(world, 8);
  soccer::Hear hear = said_by(2, 0);
  for (const char* text : {"hello", "b12", "", "Zzzzzzzzzz", "s9"}) {
    hear.text = text;
    on_hear(world, hear);
  }
  EXPECT_EQ(world.ball.pos_count, kNever);
  EXPECT_TRUE(world.teammates.empty());
}

}  // namespace
}  // namespace cls::player
