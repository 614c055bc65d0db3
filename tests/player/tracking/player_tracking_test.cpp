// Player tracking: data association, uniform numbers, lost players.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "player/perception/perception.h"
#include "tests/player/tracking/synthetic_senses.h"

namespace cls::player {
namespace {

using testing::Each;
using testing::ElementsAre;
using tests::TruePlayer;
using tests::TrueWorld;

struct Scene {
  TrueWorld truth;
  WorldModel world;

  Scene() {
    on_init(world, {Side::kLeft, 7, PlayMode::kPlayOn}, tests::kLeftTeam, false);
    truth.self.unum = 7;
    truth.self.position = {-20.0, 0.0};
    truth.width = soccer::ViewWidth::kWide;
    truth.ball = {-60.0, 0.0};  // away from all players
  }

  TruePlayer& add(Side side, int unum, Vec2 position, Vec2 velocity = {}) {
    TruePlayer& player = truth.others.emplace_back();
    player.side = side;
    player.unum = unum;
    player.position = position;
    player.velocity = velocity;
    return player;
  }

  /// Opponents 1 to `last`, near enough for their numbers.
  void add_near_opponents(int last) {
    for (int unum = 1; unum <= last; ++unum) {
      add(Side::kRight, unum, {-12.0 + (unum % 3), 2.0 * unum - 11.0});
    }
  }

  /// The track of an opponent, which must exist.
  const PlayerState& opponent(int unum) const {
    static const PlayerState kNone;
    const PlayerState* found = world.opponent(unum);
    EXPECT_NE(found, nullptr) << unum;
    return found != nullptr ? *found : kNone;
  }

  void cycle(bool see = true) {
    on_sense_body(world, tests::sense_of(truth));
    if (see) on_see(world, tests::see_of(truth));
    update_derived(world);
    ++truth.time;
  }
};

TEST(PlayerTracking, SetsAllFieldsFromNumberedObservation) {
  Scene scene;
  TruePlayer& player = scene.add(Side::kRight, 9, {-8.0, 4.0}, {0.2, -0.1});
  player.body = 135.0;
  player.neck = 20.0;
  player.kicked = true;
  scene.add(Side::kRight, 1, {-5.0, -6.0}).goalie = true;
  scene.cycle();

  const PlayerState& seen = scene.opponent(9);
  EXPECT_LT(soccer::distance(seen.position, {-8.0, 4.0}), 0.7);
  EXPECT_LT(soccer::distance(seen.velocity, {0.2, -0.1}), 0.13);
  EXPECT_NEAR(seen.body.degrees(), 135.0, 0.6);
  EXPECT_NEAR(seen.face.degrees(), 155.0, 0.6);

  EXPECT_EQ(seen.side, Side::kRight);
  EXPECT_THAT((std::array{seen.pos_count, seen.vel_count, seen.body_count, seen.unum_count}),
              Each(0));
  EXPECT_EQ(seen.heard_pos_count, kNever);
  EXPECT_TRUE(seen.kicking);
  EXPECT_FALSE(seen.tackling);
  EXPECT_NEAR(seen.dist_from_self, 12.65, 0.7);

  EXPECT_EQ(scene.world.their_goalie_unum, 1);
  EXPECT_EQ(scene.world.last_kick.unum, 9);
  EXPECT_EQ(scene.world.their_team_name.view(), tests::kRightTeam);
}

TEST(PlayerTracking, RetainsNumberWhenOnlyTeamIsSeen) {
  Scene scene;
  scene.add(Side::kRight, 9, {-5.0, 4.0});
  scene.add(Side::kRight, 10, {-5.0, -2.0});
  scene.add(Side::kLeft, 11, {-5.0, 1.0});
  scene.cycle();
  const int id = scene.opponent(9).id;

  scene.truth.unum_far = 5.0;
  for (int i = 0; i < 10; ++i) {
    for (TruePlayer& player : scene.truth.others) player.position += Vec2{0.6, 0.2};
    scene.cycle();
  }
  EXPECT_EQ(scene.opponent(9).id, id);
  EXPECT_EQ(scene.opponent(9).unum_count, 10);
  EXPECT_EQ(scene.opponent(9).pos_count, 0);

  for (const TruePlayer& player : scene.truth.others) {
    const PlayerState* track = player.side == Side::kLeft ? scene.world.teammate(player.unum)
                                                          : scene.world.opponent(player.unum);
    ASSERT_NE(track, nullptr);
    EXPECT_LT(soccer::distance(track->position, player.position), 1.2);
  }
  EXPECT_EQ(scene.world.opponents.size(), 2U);
}

TEST(PlayerTracking, CorrectsSwappedNumbers) {
  Scene scene;
  scene.add(Side::kRight, 9, {-1.0, 4.0});
  scene.add(Side::kRight, 10, {-1.0, -4.0});
  scene.truth.unum_far = 25.0;
  scene.cycle();
  ASSERT_NE(scene.world.opponent(10), nullptr);

  // They swap positions unseen and are then seen without numbers.
  std::swap(scene.truth.others[0].position, scene.truth.others[1].position);
  scene.truth.unum_far = 15.0;
  scene.cycle();
  EXPECT_GT(scene.opponent(9).position.y, 0.0);  // not detectable

  for (int i = 0; i < 12; ++i) {
    scene.truth.others[1].position.x -= 0.6;  // the one with number 10 comes near
    scene.cycle();
  }

  EXPECT_EQ(scene.opponent(10).unum_count, 0);
  EXPECT_GT(scene.opponent(10).position.y, 0.0);
  EXPECT_LT(scene.opponent(9).position.y, 0.0);
  EXPECT_EQ(scene.world.opponents.size(), 2U);
}

TEST(PlayerTracking, MarksMissingPlayerAsGhostAndThenDropsTrack) {
  Scene scene;
  scene.add(Side::kRight, 5, {-8.0, 0.0});
  scene.cycle();
  scene.truth.others.clear();
  scene.cycle();
  EXPECT_EQ(scene.opponent(5).ghost_count, 1);
  EXPECT_EQ(scene.opponent(5).pos_count, 1);
  scene.cycle();
  EXPECT_EQ(scene.world.opponent(5), nullptr);
}

TEST(PlayerTracking, DropsUnseenPlayerAfterThirtyCycles) {
  Scene scene;
  scene.add(Side::kLeft, 5, {-8.0, 0.0});
  scene.cycle();
  for (int i = 0; i < 29; ++i) scene.cycle(false);
  ASSERT_NE(scene.world.teammate(5), nullptr);
  EXPECT_EQ(scene.world.teammate(5)->pos_count, 29);
  scene.cycle(false);
  EXPECT_EQ(scene.world.teammate(5), nullptr);
}

TEST(PlayerTracking, TracksClosePlayerBehindWithoutTeam) {
  Scene scene;
  scene.add(Side::kRight, 5, {-22.0, 0.0});
  scene.cycle();
  ASSERT_EQ(scene.world.unknowns.size(), 1U);
  EXPECT_NEAR(scene.world.unknowns[0].position.x, -22.0, 0.2);
  scene.truth.self.body = 180.0;  // turned around: the same player gets team and number
  scene.cycle();
  EXPECT_EQ(scene.world.unknowns.size(), 0U);
  ASSERT_NE(scene.world.opponent(5), nullptr);
}

TEST(PlayerTracking, AssignsRemainingNumberToLastUnnumberedPlayer) {
  Scene scene;
  scene.add_near_opponents(10);
  scene.add(Side::kRight, 11, {25.0, 10.0});  // too far for the number
  scene.cycle();
  EXPECT_EQ(scene.opponent(11).unum_count, kNever);
  EXPECT_NEAR(scene.opponent(11).position.x, 25.0, 3.0);
}

TEST(PlayerTracking, LeavesTwoUnnumberedPlayersUnnumbered) {
  Scene scene;
  scene.add_near_opponents(9);
  scene.add(Side::kRight, 10, {25.0, -10.0});
  scene.add(Side::kRight, 11, {25.0, 10.0});
  scene.cycle();
  EXPECT_EQ(scene.world.opponent(10), nullptr);
  EXPECT_EQ(scene.world.opponents.size(), 11U);
}

TEST(PlayerTracking, IdentifiesGoalieByPosition) {
  Scene scene;
  scene.truth.self.position = {30.0, 0.0};
  scene.add(Side::kRight, 1, {48.0, 1.0}).goalie = true;
  scene.add(Side::kRight, 4, {35.0, 6.0});
  scene.cycle();
  ASSERT_EQ(scene.world.their_goalie_unum, 1);

  // Lost, and seen again from afar.
  for (int i = 0; i < 31; ++i) scene.cycle(false);
  EXPECT_EQ(scene.world.opponent(1), nullptr);
  scene.truth.self.position = {0.0, 0.0};
  scene.cycle();
  EXPECT_TRUE(scene.opponent(1).goalie);
  EXPECT_NEAR(scene.opponent(1).position.x, 48.0, 3.0);
  EXPECT_EQ(scene.world.opponent(4), nullptr);
}

TEST(PlayerTracking, RetainsNumberAfterUnpredictedMove) {
  Scene scene;
  scene.add(Side::kRight, 9, {-12.0, 4.0});
  for (int i = 0; i < 4; ++i) scene.cycle();
  scene.truth.unum_far = 5.0;
  scene.truth.others[0].position = {-10.0, 6.0};  // pushed away in a collision
  scene.cycle();
  ASSERT_EQ(scene.world.opponents.size(), 1U);
  EXPECT_NEAR(scene.opponent(9).position.x, -10.0, 1.0);
}

TEST(PlayerTracking, DropsPositionsBeforeKickOff) {
  Scene scene;
  scene.add(Side::kRight, 9, {-8.0, 4.0});
  scene.cycle();
  ASSERT_NE(scene.world.opponent(9), nullptr);

  hear_referee(scene.world, 1, "goal_l_1");
  EXPECT_EQ(scene.world.opponent(9), nullptr);
  scene.truth.unum_far = 3.0;
  scene.cycle();
  EXPECT_EQ(scene.world.opponent(9), nullptr);  // a player without number
  EXPECT_EQ(scene.world.opponents.size(), 1U);
  scene.truth.unum_far = 20.0;
  scene.cycle();
  EXPECT_NE(scene.world.opponent(9), nullptr);
}

TEST(PlayerTracking, SortsListsByNumber) {
  Scene scene;
  for (const int unum : {11, 3, 8, 2}) scene.add(Side::kRight, unum, {-8.0, unum - 5.0});
  scene.add(Side::kRight, 4, {10.0, 12.0});  // too far for the number
  scene.cycle();
  std::vector<int> numbers;
  for (const PlayerState& opponent : scene.world.opponents) numbers.push_back(opponent.unum);
  EXPECT_THAT(numbers, ElementsAre(2, 3, 8, 11, 0));
}

}  // namespace
}  // namespace cls::player
