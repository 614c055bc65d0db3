// sense_body and fullstate compared with messages of rcssserver.
#include "simulator/senses/body_sense.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simulator/senses/exact_view.h"
#include "soccer/math.h"
#include "tests/simulator/senses/scene.h"

namespace cls::simulator {
namespace {

using testing::HasSubstr;

namespace math = soccer::math;

std::string sense_text(const World& world, const Player& player) {
  std::string text;
  soccer::format(sense_body(world, player.slot()), player.client_version, text);
  return text;
}

std::string full_state_text(const World& world, const Player& player) {
  soccer::FullState full;
  full_state(world, player.slot(), full);
  std::string text;
  soccer::format(full, player.client_version, text);
  return text;
}

// Three players before kick-off; the first has executed many commands.
World recorded_scene() {
  World world = empty_pitch();
  world.mode = PlayMode::kBeforeKickOff;
  Player& me = place(world, Side::kLeft, 1, {-3, -37}, 9.63341, 19);

  me.neck = math::to_radians(20.0000001);
  me.view.width = soccer::ViewWidth::kNarrow;
  me.view.focus_distance = 10;
  me.view.focus_direction = math::to_radians(20);
  me.stamina = {8000, 1, 1, 130450};
  me.counters.dash = 2;
  me.counters.turn = 1;
  me.counters.say = 2;
  me.counters.turn_neck = 1;
  me.counters.change_view = 2;
  me.counters.change_focus = 1;
  me.counters.pointto = 1;
  me.counters.attentionto = 1;
  me.attention = soccer::slot_of(Side::kLeft, 2);
  me.arm = {me.position + soccer::polar_degrees(10, 9.63341 + 20 + 20), 1};
  place(world, Side::kLeft, 2, {-6, -37}, 0, 18).goalie = true;
  place(world, Side::kRight, 1, {3, -37}, 0, 14);

  return world;
}

TEST(BodySense, MatchesRcssserver) {
  const World world = recorded_scene();
  EXPECT_EQ(sense_text(world, world.player(Side::kLeft, 1)),
            "(sense_body 0 (view_mode high narrow) (stamina 8000 1 130450) (speed 0 -29) "
            "(head_angle 20) (kick 0) (dash 2) (turn 1) (say 2) (turn_neck 1) (catch 0) (move 0) "
            "(change_view 2) (change_focus 1) (arm (movable 4) (expires 19) (target 10 20) (count "
            "1)) (focus (target l 2) (count 1)) (tackle (expires 0) (count 0)) (collision none) "
            "(foul (charged 0) (card none)) (focus_point 10 20))");
}

TEST(BodySense, MatchesRcssserverForOldClient) {
  const World world = recorded_scene();
  EXPECT_EQ(sense_text(world, world.player(Side::kRight, 1)),
            "(sense_body 0 (view_mode high normal) (stamina 8000 1 130600) (speed 0 0) "
            "(head_angle 0) (kick 0) (dash 0) (turn 0) (say 0) (turn_neck 0) (catch 0) (move 0) "
            "(change_view 0) (arm (movable 0) (expires 0) (target 0 0) (count 0)) (focus (target "
            "none) (count 0)) (tackle (expires 0) (count 0)) (collision none) (foul (charged 0) "
            "(card none)))");
}

TEST(BodySense, TruncatesDirectionsAndRoundsSpeed) {
  World world = empty_pitch();
  Player& me = place(world, Side::kRight, 3, {0, 0}, -170);
  me.neck = math::to_radians(-29.9999);
  me.velocity = soccer::polar_degrees(0.1249, 175.5);
  const soccer::SenseBody sense = sense_body(world, me.slot());
  EXPECT_DOUBLE_EQ(sense.speed, 0.12);
  EXPECT_EQ(sense.speed_direction, 15);  // 175.5 + 170 + 29.9999 - 360 = 15.4999
  EXPECT_EQ(sense.head_angle, -29);
}

TEST(BodySense, ReportsCollisionsFoulsTacklesAndCards) {
  World world = empty_pitch();
  Player& me = place(world, Side::kLeft, 3, {0, 0});
  me.contacts = {true, false, true};
  me.tackle_cycles = 9;
  me.counters.tackle = 2;
  me.foul_cycles = 4;
  me.state |= state::kYellowCard;
  const std::string text = sense_text(world, me);
  EXPECT_THAT(
      text, HasSubstr("(tackle (expires 9) (count 2)) (collision (ball) (post)) (foul (charged 4) "
                      "(card yellow))"))
      << text;
  EXPECT_TRUE(me.contacts.ball) << "who sends it clears them";
}

TEST(FullView, MatchesRcssserver) {
  const World world = recorded_scene();
  EXPECT_EQ(full_state_text(world, world.player(Side::kLeft, 1)),
            "(fullstate 0 (pmode before_kick_off) (vmode high narrow) (count 0 2 1 0 0 1 2 2 1) "
            "(arm (movable 4) (expires 19) (target 10 20) (count 1)) (score 0 0) ((b) 0 0 0 0) ((p "
            "l 1 0) -3 -37 0 0 9.63341 20 10 0.349066 (focus_point 10 20) (stamina 8000 1 1 "
            "130450)) ((p l 2 g 0) -6 -37 0 0 0 0 (focus_point 0 0) (stamina 8000 1 1 130600)) ((p "
            "r 1 0) 3 -37 0 0 0 0 (focus_point 0 0) (stamina 8000 1 1 130600)))");
}

TEST(FullView, ReportsOwnScoreFirstAndCaughtBall) {
  World world = recorded_scene();
  world.team(Side::kLeft).score = 3;
  world.mode = PlayMode::kFreeKickLeft;
  world.ball_catcher = soccer::slot_of(Side::kLeft, 2);
  const std::string text = full_state_text(world, world.player(Side::kRight, 1));
  EXPECT_THAT(text, HasSubstr("(pmode goalie_catch_ball_l)"));
  EXPECT_THAT(text, HasSubstr("(score 0 3)"));
}

}  // namespace
}  // namespace cls::simulator
