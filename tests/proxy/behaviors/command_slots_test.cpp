// Which commands are rejected or clamped, and in which order they are sent.
#include "player/commands/command_slots.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/known_pitch.h"

namespace cls::proxy {
namespace {

using soccer::PlayMode;
using soccer::Side;
using soccer::Vec2;
using tests::KnownPitch;

const double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string text_of(const player::CommandSlots& slots, bool done = false) {
  std::vector<soccer::PlayerCommand> commands;
  slots.compose(commands, done);
  std::string text;
  for (const soccer::PlayerCommand& command : commands) {
    EXPECT_TRUE(soccer::format(command, text));
  }
  return text;
}

TEST(CommandSlots, SendsTurnZeroWithoutBodyCommand) {
  KnownPitch pitch;
  EXPECT_EQ(text_of(player::CommandSlots(pitch.world)), "(turn 0)");
  pitch.world.self.tackle_expires_in = 3;
  EXPECT_EQ(text_of(player::CommandSlots(pitch.world)), "");
}

TEST(CommandSlots, ComposesInWireOrder) {
  KnownPitch pitch;
  player::CommandSlots slots(pitch.world);

  EXPECT_TRUE(slots.say("abc"));
  EXPECT_TRUE(slots.attention_to(Side::kLeft, 5));
  EXPECT_TRUE(slots.point_to({10.0, 0.0}));
  EXPECT_TRUE(slots.change_focus(7.5, 10.0));
  EXPECT_TRUE(slots.change_view(soccer::ViewWidth::kWide));
  EXPECT_TRUE(slots.turn_neck(-33.4));
  EXPECT_TRUE(slots.dash(80.0, -30.0));
  EXPECT_EQ(text_of(slots, true),
            "(dash 80 -30)(turn_neck -33)(change_view wide)(change_focus 7.5 10)(pointto 10 0)"
            "(attentionto our 5)(done)(say \"abc\")");
}

TEST(CommandSlots, ClampsDashToServerLimitsAndStamina) {
  KnownPitch pitch;
  player::CommandSlots slots(pitch.world);
  EXPECT_TRUE(slots.dash(150.0, 33.4));
  EXPECT_EQ(text_of(slots), "(dash 100 33)");
  EXPECT_TRUE(slots.dash(-50.0));
  EXPECT_EQ(text_of(slots), "(dash 0)");
  pitch.set_stamina(3.0);
  EXPECT_TRUE(slots.dash(100.0));
  EXPECT_EQ(text_of(slots), "(dash 53)");
}

TEST(CommandSlots, CompensatesTurnForInertia) {
  KnownPitch pitch;
  pitch.place_self({}, 0.0, {0.3, 0.4});
  player::CommandSlots slots(pitch.world);
  EXPECT_TRUE(slots.turn(20.0));
  EXPECT_EQ(text_of(slots), "(turn 70)");
  EXPECT_NEAR(slots.next_body().degrees(), 20.0, 1e-9);
  EXPECT_TRUE(slots.turn(90.0));
  EXPECT_EQ(text_of(slots), "(turn 180)");
}

TEST(CommandSlots, RejectsBodyCommandsWhileFrozen) {
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.0});
  pitch.world.self.foul_charged = 2;
  player::CommandSlots slots(pitch.world);
  EXPECT_FALSE(slots.dash(50.0));
  EXPECT_FALSE(slots.turn(50.0));
  EXPECT_FALSE(slots.kick(50.0, 0.0));
  EXPECT_FALSE(slots.tackle(0.0));
  EXPECT_FALSE(slots.move({-5.0, 0.0}));
  EXPECT_TRUE(slots.turn_neck(10.0));
  EXPECT_FALSE(slots.has_body());
}

TEST(CommandSlots, RejectsKickWithoutKickableBall) {
  KnownPitch pitch;
  player::CommandSlots slots(pitch.world);
  EXPECT_FALSE(slots.kick(50.0, 0.0));
  pitch.place_ball({0.6, 0.0});
  EXPECT_TRUE(slots.kick(150.0, 200.0));
  EXPECT_EQ(text_of(slots), "(kick 100 -160)");
  EXPECT_TRUE(slots.kick(-20.0, 0.0));
  EXPECT_EQ(text_of(slots), "(kick 0 0)");
}

TEST(CommandSlots, AimsFarCornerOfCatchAreaAtBall) {
  KnownPitch pitch;
  pitch.world.unum = 1;
  pitch.place_ball({0.0, 1.2});
  player::CommandSlots slots(pitch.world);
  EXPECT_FALSE(slots.catch_ball()) << "not the goalie";
  pitch.world.goalie = true;
  EXPECT_TRUE(slots.catch_ball());
  // The corner of the rectangle 1.2 x 1.0 lies atan(0.5 / 1.2) = 22.62 degrees off its axis.
  EXPECT_NEAR(std::get<soccer::Catch>(slots.body()).direction, 90.0 - 22.62, 0.005);
  pitch.set_mode(PlayMode::kKickInLeft);
  EXPECT_FALSE(player::CommandSlots(pitch.world).catch_ball());
}

TEST(CommandSlots, AcceptsMoveBeforeKickOffAndAfterCatch) {
  KnownPitch pitch;
  player::CommandSlots slots(pitch.world);
  EXPECT_FALSE(slots.move({-10.0, 0.0}));
  pitch.set_mode(PlayMode::kBeforeKickOff);
  EXPECT_TRUE(slots.move({10.0, 40.0}));
  EXPECT_EQ(text_of(slots), "(move -0.1 34)");
  pitch.set_mode(PlayMode::kFreeKickLeft);
  pitch.world.goalie = true;

  EXPECT_FALSE(slots.move({-40.0, 0.0}));

  pitch.world.game.goalie_catch = true;
  EXPECT_TRUE(slots.move({0.0, 30.0}));
  EXPECT_EQ(text_of(slots), "(move -37 19.16)");
}

TEST(CommandSlots, ClampsNeckToRange) {
  KnownPitch pitch;
  pitch.set_neck(60.0);
  player::CommandSlots slots(pitch.world);
  EXPECT_TRUE(slots.turn_neck(70.0));
  EXPECT_DOUBLE_EQ(slots.next_neck(), 90.0);
  EXPECT_TRUE(slots.turn_neck(-1e30));
  EXPECT_DOUBLE_EQ(slots.next_neck(), -90.0);
}

TEST(CommandSlots, ChangesViewOnlyToDifferentWidth) {
  KnownPitch pitch;
  player::CommandSlots slots(pitch.world);
  EXPECT_FALSE(slots.change_view(soccer::ViewWidth::kNarrow));
  EXPECT_TRUE(slots.view_requested());
  EXPECT_EQ(text_of(slots), "(turn 0)");
  EXPECT_TRUE(slots.change_view(soccer::ViewWidth::kNormal));
  EXPECT_EQ(slots.next_view_width(), soccer::ViewWidth::kNormal);
}

TEST(CommandSlots, ClampsFocusToRangeAndViewCone) {
  KnownPitch pitch;
  pitch.set_focus(30.0, 0.0);
  player::CommandSlots slots(pitch.world);
  EXPECT_TRUE(slots.change_focus(25.0, -80.0));
  EXPECT_EQ(text_of(slots), "(turn 0)(change_focus 10 -30)");
}

TEST(CommandSlots, RejectsPointToWhileArmIsImmovable) {
  KnownPitch pitch;
  pitch.place_self({1.0, 0.0}, 90.0);
  player::CommandSlots slots(pitch.world);
  EXPECT_TRUE(slots.point_to({11.0, 0.0}));
  EXPECT_EQ(text_of(slots), "(turn 0)(pointto 10 -90)");
  EXPECT_TRUE(slots.point_to_off());
  EXPECT_EQ(text_of(slots), "(turn 0)(pointto off)");
  pitch.world.self.arm.movable_in = 2;
  EXPECT_FALSE(slots.point_to({11.0, 0.0}));
  EXPECT_FALSE(slots.point_to_off());
}

TEST(CommandSlots, RejectsAttentionToSelfAndInvalidPlayers) {
  KnownPitch pitch;
  player::CommandSlots slots(pitch.world);
  EXPECT_FALSE(slots.attention_to(Side::kLeft, 7));
  EXPECT_FALSE(slots.attention_to(Side::kRight, 12));
  EXPECT_FALSE(slots.attention_to(Side::kNeutral, 3));
  EXPECT_TRUE(slots.attention_to(Side::kRight, 7));
  EXPECT_EQ(text_of(slots), "(turn 0)(attentionto opp 7)");
  EXPECT_TRUE(slots.attention_to_off());
  EXPECT_EQ(text_of(slots), "(turn 0)(attentionto off)");
}

TEST(CommandSlots, RejectsSayTextThatDoesNotFit) {
  KnownPitch pitch;
  player::CommandSlots slots(pitch.world);
  EXPECT_TRUE(slots.say("b12345"));
  EXPECT_FALSE(slots.say("p6789"));
  EXPECT_TRUE(slots.say("w"));
  EXPECT_FALSE(slots.say("\""));
  EXPECT_EQ(slots.say_text(), "b12345w");
}

// The arguments are finite, but a faulty server has described the pitch.
TEST(CommandSlots, SendsNoInfiniteNumber) {
  KnownPitch pitch;
  player::CommandSlots slots(pitch.world);
  EXPECT_FALSE(slots.point_to({1e306, 0.0}));
  pitch.place_self({}, 0.0, {kNaN, 0.0});
  EXPECT_FALSE(slots.turn(20.0));
  pitch.world.self.focus_distance = kNaN;
  EXPECT_FALSE(slots.change_focus(1.0, 0.0));
  EXPECT_EQ(text_of(slots), "(turn 0)");
}

TEST(CommandSlots, RejectsNaN) {
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.0});
  pitch.set_mode(PlayMode::kBeforeKickOff);
  player::CommandSlots slots(pitch.world);

  EXPECT_FALSE(slots.dash(kNaN));
  EXPECT_FALSE(slots.turn(kNaN));
  EXPECT_FALSE(slots.kick(kNaN, 0.0));
  EXPECT_FALSE(slots.tackle(kNaN));
  EXPECT_FALSE(slots.move({kNaN, 0.0}));
  EXPECT_FALSE(slots.turn_neck(kNaN));
  EXPECT_FALSE(slots.change_focus(kNaN, 0.0));
  EXPECT_FALSE(slots.point_to({0.0, kNaN}));
  EXPECT_EQ(text_of(slots), "(turn 0)");
}

}  // namespace
}  // namespace cls::proxy
