// Home positions by play mode, ball and offside line.
#include "player/movement/home_positions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/known_pitch.h"

namespace cls::player {
namespace {

using testing::Each;
using testing::Field;
using testing::Le;

TEST(HomePositions, FormationDependsOnFirstTeamAtBall) {
  tests::KnownPitch pitch;
  pitch.place_ball({10.0, 0.0});
  pitch.add_opponent(5, {30.0, 0.0});
  EXPECT_EQ(formation_kind(pitch.world), FormationKind::kOffense);
  pitch.add_opponent(6, {10.5, 0.0});
  EXPECT_EQ(formation_kind(pitch.world), FormationKind::kDefense);
}

TEST(HomePositions, FormationDependsOnPlayMode) {
  tests::KnownPitch pitch;
  const auto kind_in = [&](PlayMode mode) {
    pitch.set_mode(mode);
    return formation_kind(pitch.world);
  };

  EXPECT_EQ(kind_in(PlayMode::kBeforeKickOff), FormationKind::kBeforeKickOff);
  EXPECT_EQ(kind_in(PlayMode::kGoalRight), FormationKind::kBeforeKickOff);
  EXPECT_EQ(kind_in(PlayMode::kKickInLeft), FormationKind::kKickInOur);
  EXPECT_EQ(kind_in(PlayMode::kCornerKickRight), FormationKind::kSetPlayTheir);
  EXPECT_EQ(kind_in(PlayMode::kGoalKickLeft), FormationKind::kGoalKickOur);
  EXPECT_EQ(kind_in(PlayMode::kGoalKickRight), FormationKind::kGoalKickTheir);
  EXPECT_EQ(kind_in(PlayMode::kIndirectFreeKickLeft), FormationKind::kIndirectOur);
  EXPECT_EQ(kind_in(PlayMode::kBackPassLeft), FormationKind::kIndirectTheir) << "our offense";
  EXPECT_EQ(kind_in(PlayMode::kFreeKickLeft), FormationKind::kSetPlayOur);

  pitch.place_ball({44.0, 3.0});
  EXPECT_EQ(kind_in(PlayMode::kFoulChargeRight), FormationKind::kIndirectOur) << "in their area";
  pitch.place_ball({0.0, 3.0});
  EXPECT_EQ(kind_in(PlayMode::kFoulChargeRight), FormationKind::kSetPlayOur);
}

TEST(HomePositions, StayInOwnHalfBeforeKickOffAndOnsideInPlay) {
  tests::KnownPitch pitch;
  pitch.set_mode(PlayMode::kBeforeKickOff);
  EXPECT_THAT(home_positions(pitch.world), Each(Field(&Vec2::x, Le(0.0))));

  pitch.set_mode(PlayMode::kPlayOn);
  pitch.place_ball({5.0, 0.0});
  pitch.add_opponent(1, {50.0, 0.0});
  pitch.add_opponent(4, {12.0, 5.0});
  ASSERT_LT(pitch.world.lines.offside, 13.0);
  EXPECT_THAT(home_positions(pitch.world),
              Each(Field(&Vec2::x, Le(pitch.world.lines.offside - 0.9))));
}

}  // namespace
}  // namespace cls::player
