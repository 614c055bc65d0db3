// Sensor messages of rcssserver: sense_body, see, fullstate, see_global.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "soccer/messages/full_state.h"
#include "soccer/messages/global_view.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"
#include "soccer/pitch.h"
#include "soccer/protocol/scanner.h"

namespace cls::soccer {
namespace {

using testing::ElementsAre;
using testing::FieldsAre;

template <typename Message>
Message read(std::string_view text) {
  Message message;
  const base::Result<void> done = parse(text, message);
  EXPECT_TRUE(done) << (done ? "" : done.error().message);
  return message;
}

template <typename Message>
std::string error_of(std::string_view text) {
  Message message;
  const base::Result<void> done = parse(text, message);
  return done ? "no error" : done.error().message;
}

constexpr std::string_view kSense18 =
    "(sense_body 12 (view_mode high narrow) (stamina 7945 0.92353 130450) (speed 0.42 -29) "
    "(head_angle 20) (kick 3) (dash 2) (turn 1) (say 4) (turn_neck 5) (catch 6) (move 7) "
    "(change_view 8) (change_focus 9) (arm (movable 4) (expires 19) (target 10 20) (count 1)) "
    "(focus (target l 2) (count 1)) (tackle (expires 9) (count 3)) (collision (ball) (post)) "
    "(foul (charged 4) (card yellow)) (focus_point 10 -12.5))";

TEST(SenseBody, ParsesAllFields) {
  const SenseBody sense = read<SenseBody>(kSense18);

  EXPECT_EQ(sense.time, 12);
  EXPECT_EQ(sense.width, ViewWidth::kNarrow);
  EXPECT_EQ(sense.quality, ViewQuality::kHigh);
  EXPECT_EQ(sense.stamina, 7945);
  EXPECT_EQ(sense.effort, 0.92353);
  EXPECT_EQ(sense.capacity, 130450);
  EXPECT_EQ(sense.speed, 0.42);
  EXPECT_EQ(sense.speed_direction, -29);
  EXPECT_EQ(sense.head_angle, 20);

  EXPECT_THAT(sense.counts, FieldsAre(3, 2, 1, 4, 5, 6, 7, 8, 9));
  EXPECT_THAT(sense.arm, FieldsAre(4, 19, 10, 20, 1));
  EXPECT_EQ(sense.attention_side, Side::kLeft);
  EXPECT_EQ(sense.attention_unum, 2);
  EXPECT_EQ(sense.tackle_expires_in, 9);
  EXPECT_EQ(sense.tackle_count, 3);

  EXPECT_TRUE(sense.collided_with_ball);
  EXPECT_FALSE(sense.collided_with_player);
  EXPECT_TRUE(sense.collided_with_post);
  EXPECT_EQ(sense.foul_charged, 4);
  EXPECT_EQ(sense.card, Card::kYellow);
  EXPECT_TRUE(sense.has_focus_point);
  EXPECT_EQ(sense.focus_distance, 10);
  EXPECT_EQ(sense.focus_direction, -12.5);

  std::string text;
  format(sense, 18, text);
  EXPECT_EQ(text, kSense18);
}

TEST(SenseBody, OmitsFocusPointForOlderClients) {
  constexpr std::string_view kSense14 =
      "(sense_body 0 (view_mode high normal) (stamina 8000 1 130600) (speed 0 0) (head_angle 0) "
      "(kick 0) (dash 0) (turn 0) (say 0) (turn_neck 0) (catch 0) (move 0) (change_view 0) "
      "(arm (movable 0) (expires 0) (target 0 0) (count 0)) (focus (target none) (count 0)) "
      "(tackle (expires 0) (count 0)) (collision none) (foul (charged 0) (card none)))";
  const SenseBody sense = read<SenseBody>(kSense14);
  EXPECT_FALSE(sense.has_focus_point);
  EXPECT_EQ(sense.attention_side, Side::kNeutral);

  std::string text;
  format(sense, 17, text);
  EXPECT_EQ(text, kSense14);
}

TEST(SenseBody, ReportsByteOfError) {
  EXPECT_EQ(error_of<SenseBody>("(sense_body 5 (view_mode high odd)"),
            "sense_body: byte 30: expected 'narrow, normal or wide', found 'odd)'");
  EXPECT_EQ(error_of<SenseBody>("(sense_body x"),
            "sense_body: byte 12: expected 'an integer', found 'x'");
  EXPECT_EQ(error_of<SenseBody>(kSense18.substr(0, 40)),
            "sense_body: byte 37: expected ') (stamina ', found ') ('");
  EXPECT_EQ(error_of<SenseBody>(std::string(kSense18) + "\n"),
            "sense_body: byte 403: expected 'the end', found '\\x0a'");
}

// Sums of counts and angles must fit an int.
TEST(SenseBody, RefusesIntegersThatNoServerReaches) {
  const std::string text(kSense18);
  const auto with_kicks = [&text](std::string_view kicks) {
    return std::string(text).replace(text.find("(kick 3)"), 8, fmt::format("(kick {})", kicks));
  };
  EXPECT_EQ(read<SenseBody>(with_kicks("268435455")).counts.kick, kMaxInteger);
  EXPECT_NE(error_of<SenseBody>(with_kicks("268435456")), "no error");
  EXPECT_NE(error_of<SenseBody>(with_kicks("-268435456")), "no error");
}

TEST(See, ParsesAllFormsOfObjects) {
  constexpr std::string_view kText =
      "(see 86 ((f c t) 4.3 15 0 -0) ((g l) 66.7 34) ((f l b 30) 27) ((b) 13.5 -20 0.27 -1.5) "
      "((P) 3 150) ((F) 1.5 -170) ((G) 2 99) ((B) 0.7 -100) "
      "((p \"RightTeam\" 1 goalie) 6 -30 0 0 -30 -31 45 k) ((p \"TA\" 11) 7.4 5 0.1 2.2 3 -4) "
      "((p \"TA\") 30 5 -100) ((p \"TA\") 33.1 6 t) ((p) 60.3 2) ((l r) 64.1 60) ((l t) 6 -30))";

  const See see = read<See>(kText);
  EXPECT_EQ(see.time, 86);
  std::vector<ObservedKind> kinds;
  for (const Observation& object : see.objects) kinds.push_back(object.kind);
  using enum ObservedKind;
  ASSERT_THAT(kinds, ElementsAre(kLandmark, kLandmark, kLandmark, kBall, kClosePlayer, kCloseFlag,
                                 kCloseGoal, kCloseBall, kPlayer, kPlayer, kPlayer, kPlayer,
                                 kPlayer, kLine, kLine));

  EXPECT_EQ(kLandmarks[see.objects[0].index].name, "f c t");
  EXPECT_EQ(see.objects[0].detail, ObservedDetail::kMotion);
  EXPECT_EQ(kLandmarks[see.objects[1].index].name, "g l");
  EXPECT_EQ(see.objects[1].detail, ObservedDetail::kPosition);
  EXPECT_EQ(see.objects[1].distance, 66.7);
  EXPECT_EQ(see.objects[1].direction, 34);
  EXPECT_EQ(see.objects[2].detail, ObservedDetail::kDirection);
  EXPECT_EQ(see.objects[2].direction, 27);
  EXPECT_EQ(see.objects[3].distance_change, 0.27);
  EXPECT_EQ(see.objects[3].direction_change, -1.5);

  const Observation& goalie = see.objects[8];
  EXPECT_EQ(goalie.team.view(), "RightTeam");
  EXPECT_EQ(goalie.unum, 1);
  EXPECT_TRUE(goalie.goalie);
  EXPECT_EQ(goalie.detail, ObservedDetail::kPose);
  EXPECT_EQ(goalie.body, -30);
  EXPECT_EQ(goalie.head, -31);
  EXPECT_TRUE(goalie.pointing);
  EXPECT_EQ(goalie.point_direction, 45);
  EXPECT_EQ(goalie.mark, ActionMark::kKicked);
  EXPECT_FALSE(see.objects[9].pointing);
  EXPECT_FALSE(see.objects[9].goalie);
  EXPECT_EQ(see.objects[10].unum, 0);
  EXPECT_TRUE(see.objects[10].pointing);
  EXPECT_EQ(see.objects[10].point_direction, -100);
  EXPECT_EQ(see.objects[11].mark, ActionMark::kTackling);
  EXPECT_TRUE(see.objects[12].team.empty());
  EXPECT_EQ(see.objects[13].index, static_cast<int>(PitchLine::kRight));

  std::string text;
  format(see, text);
  EXPECT_EQ(text, kText);
}

TEST(See, ParsesAllLandmarks) {
  for (int i = 0; i < kLandmarkCount; ++i) {
    const std::string text = "(see 1 ((" + std::string(kLandmarks[i].name) + ") 5 6))";
    const See see = read<See>(text);
    ASSERT_EQ(see.objects.size(), 1u) << text;
    EXPECT_EQ(see.objects[0].index, i) << text;
  }
}

TEST(See, MayBeEmpty) { EXPECT_TRUE(read<See>("(see 0)").objects.empty()); }

TEST(See, RejectsInvalidForms) {
  for (const char* text : {"",
                           "(see",
                           "(see 0",
                           "(see 0 )",
                           "(see 0 ((f c t) 4.3 15 0 0)",
                           "(see 0 ((f c x) 1 2))",
                           "(see 0 ((f c t)))",
                           "(see 0 ((f c t) 1 2 3))",
                           "(see 0 ((f c t) 1 2 3 4 5 6))",
                           "(see 0 ((b) 1 2 t))",
                           "(see 0 ((p \"A\" 12) 1 2 3 4 5 6))",
                           "(see 0 ((p \"\" 1) 1 2))",
                           "(see 0 ((p \"A\" 1) 1 2 3 4))",
                           "(see 0 ((p \"A\" 1) 1 2 3 4 5))",
                           "(see 0 ((p \"SixteenLettersXY\") 1 2))",
                           "(see 0 ((p \"A\" 1) 1 2 3 4 5 6 7 8))",
                           "(see 0 ((b) 1 2.5))",
                           "(see 0 ((b) 1 99999))",
                           "(see 0 ((b) nan 2))",
                           "(see 0 ((l x) 1 2))",
                           "(see 0  ((b) 1 2))",
                           "(see 0 ((b) 1 2) )",
                           "(see 0 ((p \"A\" 1) 1 2 k t))"}) {
    EXPECT_NE(error_of<See>(text), "no error") << text;
  }
}

TEST(See, LimitsNumberOfObjects) {
  std::string text = "(see 0";
  for (int i = 0; i < 5000; ++i) text += " ((b) 1 2)";
  text += ")";
  See see;
  EXPECT_FALSE(parse(text, see));
  EXPECT_EQ(see.objects.size(), kMaxObservations);
}

TEST(See, ReusesMemory) {
  See see;
  const std::string text = "(see 0 ((f c) 1 2) ((b) 1 2) ((p \"A\" 1) 1 2 3 4 5 6))";
  ASSERT_TRUE(parse(text, see));
  const Observation* memory = see.objects.data();
  ASSERT_TRUE(parse(text, see));
  EXPECT_EQ(see.objects.data(), memory);
}

TEST(FullState, ParsesAllFields) {
  constexpr std::string_view kText =
      "(fullstate 3 (pmode goalie_catch_ball_r) (vmode high narrow) (count 1 2 3 4 5 6 7 8 9) "
      "(arm (movable 4) (expires 19) (target 10 20) (count 1)) (score 2 3) ((b) -1.5 0.25 1 -0) "
      "((p l 1 0) -3 -37 0 0 9.63341 20 10 0.349066 (focus_point 10 20) (stamina 8000 1 1 130450)) "
      "((p r 2 g 7) -6 -37 0.5 0 0 0 (focus_point 0 0) (stamina 8000 1 0.5 130600) k y))";

  const FullState state = read<FullState>(kText);
  EXPECT_EQ(state.mode, PlayMode::kFreeKickRight);
  EXPECT_TRUE(state.ball_caught);
  EXPECT_THAT(state.counts, FieldsAre(1, 2, 3, 8, 6, 4, 5, 7, 9));
  EXPECT_EQ(state.our_score, 2);
  EXPECT_EQ(state.opponent_score, 3);
  EXPECT_EQ(state.ball_position, (Vec2{-1.5, 0.25}));
  EXPECT_EQ(state.ball_velocity, (Vec2{1, 0}));
  ASSERT_EQ(state.players.size(), 2u);
  EXPECT_TRUE(state.players[0].pointing);
  EXPECT_EQ(state.players[0].point_direction_radians, 0.349066);
  EXPECT_EQ(state.players[0].body, 9.63341);
  EXPECT_EQ(state.players[0].neck, 20);
  EXPECT_EQ(state.players[0].focus_direction, 20);

  const FullStatePlayer& goalie = state.players[1];
  EXPECT_EQ(goalie.side, Side::kRight);
  EXPECT_EQ(goalie.unum, 2);
  EXPECT_TRUE(goalie.goalie);
  EXPECT_EQ(goalie.type, 7);
  EXPECT_FALSE(goalie.pointing);
  EXPECT_EQ(goalie.recovery, 0.5);
  EXPECT_EQ(goalie.mark, ActionMark::kKicked);
  EXPECT_EQ(goalie.card, Card::kYellow);

  std::string text;
  format(state, 19, text);
  EXPECT_EQ(text, kText);
}

TEST(GlobalView, ParsesAllFields) {
  constexpr std::string_view kText =
      "(see_global 7 ((g r) 52.5 0) ((g l) -52.5 0) ((b) 10 5 1 0) "
      "((p \"LeftTeam\" 1) -10.2542 -9.52485 0 0.1 19 90) "
      "((p \"LeftTeam\" 2 goalie) -6 -37 0 0 0 -45 77 t) "
      "((p \"RightTeam\" 1) 3 -37 0 0 0 0 f r))";

  const GlobalView view = read<GlobalView>(kText);
  EXPECT_FALSE(view.is_look_reply);
  EXPECT_EQ(view.time, 7);
  EXPECT_EQ(view.ball_position, (Vec2{10, 5}));
  EXPECT_EQ(view.ball_velocity, (Vec2{1, 0}));
  ASSERT_EQ(view.players.size(), 3u);
  EXPECT_EQ(view.players[0].team.view(), "LeftTeam");
  EXPECT_EQ(view.players[0].position, (Vec2{-10.2542, -9.52485}));
  EXPECT_EQ(view.players[0].body, 19);
  EXPECT_EQ(view.players[0].neck, 90);
  EXPECT_TRUE(view.players[1].goalie);
  EXPECT_TRUE(view.players[1].pointing);
  EXPECT_EQ(view.players[1].point_direction, 77);
  EXPECT_EQ(view.players[1].mark, ActionMark::kTackling);
  EXPECT_FALSE(view.players[2].pointing);
  EXPECT_EQ(view.players[2].mark, ActionMark::kFoulCharged);
  EXPECT_EQ(view.players[2].card, Card::kRed);

  std::string text;
  format(view, text);
  EXPECT_EQ(text, kText);
}

TEST(GlobalView, ParsesReplyToLook) {
  constexpr std::string_view kText =
      "(ok look 0 ((g r) 52.5 0) ((g l) -52.5 0) ((b) 0 0 0 0) ((p \"HELIOS_L\" 1 goalie) -3 -37 0 "
      "0 0 0))";
  const GlobalView view = read<GlobalView>(kText);
  EXPECT_TRUE(view.is_look_reply);
  std::string text;
  format(view, text);
  EXPECT_EQ(text, kText);
}

}  // namespace
}  // namespace cls::soccer
