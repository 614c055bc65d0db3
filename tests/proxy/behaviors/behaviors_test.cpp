// Behaviors on the pitch: goalie, set plays, shoot-out, announced passes.
#include <gtest/gtest.h>

#include <cmath>

#include "base/index.h"
#include "player/behaviors/behaviors.h"
#include "player/estimates/estimates.h"
#include "player/movement/home_positions.h"
#include "player/perception/say_message.h"
#include "proxy/messages/shoot_out_view.h"
#include "tests/support/known_pitch.h"

namespace cls::proxy {
namespace {

using protos::PlayerAction;
using protos::PlayerActions;
using soccer::PlayMode;
using soccer::Side;
using soccer::Vec2;
using tests::KnownPitch;

const auto kGoalie = [](PlayerActions& reply) { reply.add_actions()->mutable_helios_goalie(); };
const auto kGoalieMove = [](PlayerActions& reply) {
  reply.add_actions()->mutable_helios_goalie_move();
};
const auto kSetPlay = [](PlayerActions& reply) { reply.add_actions()->mutable_helios_set_play(); };
const auto kPenalty = [](PlayerActions& reply) { reply.add_actions()->mutable_helios_penalty(); };
const auto kFreeKick = [](PlayerActions& reply) {
  reply.add_actions()->mutable_bhv_goalie_free_kick();
};

TEST(HeliosGoalie, CatchesBallAndKicksBackPass) {
  KnownPitch pitch;
  pitch.make_goalie();
  pitch.place_self({-50.0, 0.0});
  pitch.place_ball({-49.1, 0.3}, {-1.0, 0.0});
  KnownPitch passed_back = pitch;
  pitch.act(kGoalie);
  EXPECT_NE(pitch.sent<soccer::Catch>(), nullptr);
  passed_back.world.last_kick = {Side::kLeft, 3};
  passed_back.act(kGoalie);
  EXPECT_EQ(passed_back.sent<soccer::Catch>(), nullptr);
  EXPECT_NE(passed_back.sent<soccer::Kick>(), nullptr);
}

TEST(HeliosGoalie, DoesNotCatchBallFromTackleOfTeammate) {
  const auto catches = [](Vec2 tackler, Vec2 goalie) {
    KnownPitch pitch;
    pitch.make_goalie();
    pitch.place_self(goalie);
    pitch.place_ball({-47.9, 8.3}, {0.4, -1.2});
    pitch.add_teammate(3, tackler);
    pitch.world.teammates.back().tackling = true;
    pitch.act(kGoalie);
    return pitch.sent<soccer::Catch>() != nullptr;
  };

  const Vec2 beside{-48.0, 7.1};
  EXPECT_FALSE(catches({-50.0, 14.5}, beside));
  EXPECT_TRUE(catches({-40.0, 14.5}, beside)) << "far from the ball's way";
}

TEST(HeliosGoalie, KicksBallOutsidePenaltyArea) {
  KnownPitch pitch;
  pitch.make_goalie();
  pitch.place_self({-30.0, 0.0});
  pitch.place_ball({-29.4, 0.0});
  pitch.act(kGoalie);
  EXPECT_GT(pitch.world.ball.velocity.x, 0.0) << "outside the penalty area";
  EXPECT_GT(pitch.world.ball.velocity.length(), 1.0);
}

TEST(HeliosGoalie, SavesShots) {
  int saved = 0;
  for (const double aim : {-5.0, -3.0, -1.0, 1.0, 3.0, 5.0}) {
    KnownPitch pitch;
    pitch.make_goalie();
    pitch.place_self({-50.0, 0.0}, 90.0);
    const Vec2 from{-34.0, 0.0};
    pitch.place_ball(from, soccer::with_length(Vec2{-52.5, aim} - from, 2.0));
    pitch.act_until(20, kGoalie, [&] {
      return pitch.sent<soccer::Catch>() != nullptr || pitch.world.ball.position.x < -52.5;
    });
    if (pitch.sent<soccer::Catch>() != nullptr) ++saved;
  }

  EXPECT_GE(saved, 5);
}

TEST(HeliosGoalieMove, CoversNearPostAgainstShotsFromTheGoalLine) {
  for (const double side : {1.0, -1.0}) {
    for (const double x : {-49.0, -50.7, -51.6}) {
      KnownPitch pitch;
      pitch.make_goalie();
      pitch.place_self({-50.0, 6.6 * side});
      const Vec2 ball{x, 12.3 * side};
      pitch.place_ball(ball);
      const Vec2 position = goalie_position(pitch.world, ball);
      // Just inside the near post, and no ball passes between it and the goalie.
      const soccer::Segment shot{ball, {-52.5, 6.4 * side}};
      EXPECT_LT(distance(shot, position), 1.0) << x << ": " << position.x << ", " << position.y;
    }
  }
}

TEST(HeliosGoalieMove, StaysBetweenBallAndGoal) {
  for (const Vec2 ball : {Vec2{-20.0, 20.0}, Vec2{-30.0, -15.0}, Vec2{0.0, 0.0}}) {
    KnownPitch pitch;
    pitch.make_goalie();
    pitch.place_self({-46.0, 0.0});
    pitch.place_ball(ball);
    pitch.add_opponent(9, ball + Vec2{0.5, 0.0});
    for (int i = 0; i < 40; ++i) pitch.act(kGoalieMove);
    EXPECT_LT(distance(pitch.world.self.position, goalie_position(pitch.world, ball)), 1.3);
    // As seen from the ball, the goalie is between the posts, not near one of them.
    using soccer::AngleDeg;
    const AngleDeg own = AngleDeg::of(pitch.world.self.position - ball);
    const double left = (AngleDeg::of(Vec2{-52.5, 7.01} - ball) - own).degrees();
    const double right = (AngleDeg::of(Vec2{-52.5, -7.01} - ball) - own).degrees();
    EXPECT_LT(left * right, 0.0);
    EXPECT_GT(std::fabs(left), 0.25 * std::fabs(left - right));
    EXPECT_GT(std::fabs(right), 0.25 * std::fabs(left - right));
  }
}

TEST(HeliosGoalieMove, ComesOutForReachableBall) {
  KnownPitch pitch;
  pitch.make_goalie();
  pitch.place_self({-49.0, 0.0});
  pitch.place_ball({-42.0, 3.0});
  pitch.add_opponent(9, {-20.0, 3.0});
  const int cycles = pitch.act_until(15, kGoalieMove, [&] { return pitch.world.self.kickable; });
  EXPECT_LT(cycles, 12);
}

TEST(BhvGoalieFreeKick, WaitsMovesAndKicks) {
  KnownPitch pitch;
  pitch.make_goalie();
  pitch.place_self({-47.0, 2.0});
  pitch.place_ball({-46.4, 2.0});
  pitch.set_mode(PlayMode::kFreeKickLeft);
  pitch.world.game.goalie_catch = true;
  pitch.world.game.caught_time = 100;
  pitch.set_time(101);
  pitch.act(kFreeKick);

  EXPECT_EQ(pitch.sent<soccer::Kick>(), nullptr) << "teammates need time";
  pitch.add_opponent(9, {-42.0, 10.0});
  pitch.add_opponent(10, {-42.0, 0.0});
  pitch.set_time(155);
  pitch.act(kFreeKick);

  ASSERT_NE(pitch.sent<soccer::Move>(), nullptr);
  EXPECT_LT(pitch.sent<soccer::Move>()->y, 0.0) << "in free space";

  pitch.place_self({-43.0, -10.0});
  pitch.place_ball({-42.4, -10.0});
  pitch.add_teammate(4, {-30.0, -22.0});
  pitch.set_time(165);
  pitch.act(kFreeKick);
  EXPECT_NE(pitch.sent<soccer::Kick>(), nullptr);
}

TEST(BhvGoalieFreeKick, NeverRunsWithCaughtBall) {
  KnownPitch pitch;
  pitch.make_goalie();
  pitch.place_self({-43.0, -10.0});
  pitch.place_ball({-37.0, 2.0});  // estimated at the position before the move
  pitch.set_mode(PlayMode::kFreeKickLeft);
  pitch.world.game.goalie_catch = true;
  pitch.world.game.caught_time = 100;

  for (int cycle = 151; cycle < 160; ++cycle) {
    pitch.set_time(cycle);
    pitch.act(kFreeKick);
    EXPECT_EQ(pitch.sent<soccer::Dash>(), nullptr);
    EXPECT_EQ(pitch.sent<soccer::Move>(), nullptr);
  }
}

TEST(BhvGoalieFreeKick, MovesLikeGoalieWithoutCatch) {
  KnownPitch pitch;
  pitch.make_goalie();
  pitch.place_self({-45.0, 0.0});
  pitch.act(kFreeKick);
  EXPECT_EQ(pitch.counts(PlayerAction::kBhvGoalieFreeKick).done, 1);
  EXPECT_TRUE(pitch.sent<soccer::Dash>() != nullptr || pitch.sent<soccer::Turn>() != nullptr);
}

/// Our kick-in on the right, near the agent's home position.
KnownPitch kick_in() {
  KnownPitch pitch;
  pitch.set_mode(PlayMode::kKickInLeft);
  pitch.place_ball({10.0, -34.0});
  pitch.world.game.last_set_play_start = 100;
  pitch.world.game.set_play_count = 5;
  const Vec2 home = own_home_position(pitch.world);
  pitch.place_self(home);

  for (int unum = 2; unum <= 11; ++unum) {
    if (unum == 7) continue;
    const Vec2 position = home_positions(pitch.world)[base::index(unum - 1)];
    pitch.add_teammate(unum, position);
  }

  return pitch;
}

TEST(HeliosSetPlay, KickerGoesToBallWaitsAndPasses) {
  KnownPitch pitch = kick_in();
  // Make the agent the kicker by placing it nearest.
  pitch.place_ball(pitch.world.self.position + Vec2{6.0, -5.0});
  for (player::PlayerState& teammate : pitch.world.teammates) teammate.position.x -= 25.0;
  const int kicker = set_play_kicker(pitch.world);

  ASSERT_NE(kicker, 0);
  if (kicker != pitch.world.unum) {
    // Another number is the kicker: play that one.
    pitch.world.unum = kicker;
    for (std::size_t i = 0; i < pitch.world.teammates.size(); ++i) {
      if (pitch.world.teammates[i].unum == kicker) pitch.world.teammates[i].unum = 7;
    }
  }

  const Vec2 ball = pitch.world.ball.position;
  int kicked_at = 0;
  for (int cycle = 1; cycle <= 95 && kicked_at == 0; ++cycle) {
    pitch.world.game.set_play_count = cycle;
    pitch.act(kSetPlay);
    if (pitch.sent<soccer::Kick>() != nullptr) kicked_at = cycle;
    if (kicked_at == 0) {
      ASSERT_LT(distance(pitch.world.ball.position, ball), 0.05) << "collided with the ball";
    }
  }

  EXPECT_GT(kicked_at, 12) << "not before teammates have taken positions";
  EXPECT_GT(pitch.world.ball.velocity.length(), 0.5);
}

TEST(HeliosSetPlay, OthersTakeHomePositionsOnside) {
  KnownPitch pitch;
  pitch.set_mode(PlayMode::kFreeKickLeft);
  pitch.place_self({-30.0, 20.0});
  pitch.place_ball({-5.0, 0.0});
  pitch.add_teammate(6, {-5.5, 0.0});
  pitch.world.game.last_set_play_start = 100;
  for (int i = 0; i < 90; ++i) pitch.act(kSetPlay);
  EXPECT_LT(distance(pitch.world.self.position, own_home_position(pitch.world)), 3.5);
  EXPECT_EQ(pitch.counts(PlayerAction::kHeliosSetPlay).failed, 0);
}

TEST(HeliosSetPlay, KeepsDistanceFromTheirFreeKick) {
  for (const Vec2 ball : {Vec2{-20.0, 5.0}, Vec2{0.0, -33.5}, Vec2{-48.0, 30.0}}) {
    KnownPitch pitch;
    pitch.set_mode(PlayMode::kFreeKickRight);
    pitch.place_self(ball + Vec2{2.0, -1.0});
    pitch.place_ball(ball);
    for (int i = 0; i < 60; ++i) pitch.act(kSetPlay);
    EXPECT_GT(distance(pitch.world.self.position, ball), 9.15) << ball.x;
  }
}

TEST(HeliosSetPlay, StaysOutOfTheirPenaltyAreaAtTheirGoalKick) {
  KnownPitch pitch;
  pitch.set_mode(PlayMode::kGoalKickRight);
  pitch.place_self({44.0, 0.0});
  pitch.place_ball({47.0, 9.0});
  for (int i = 0; i < 60; ++i) pitch.act(kSetPlay);
  const Vec2 position = pitch.world.self.position;
  EXPECT_TRUE(position.x < 36.0 || std::fabs(position.y) > 20.16)
      << position.x << " " << position.y;
}

TEST(SetPlayKicker, HasOneOfTwoNearestHomePositions) {
  KnownPitch pitch = kick_in();
  const int kicker = set_play_kicker(pitch.world);
  const player::TeamPoints homes = home_positions(pitch.world);
  const Vec2 ball = pitch.world.ball.position;

  int nearer = 0;
  for (std::size_t i = 1; i < homes.size(); ++i) {
    if (distance(homes[i], ball) < distance(homes[base::index(kicker - 1)], ball)) {
      ++nearer;
    }
  }

  EXPECT_LE(nearer, 1);
  EXPECT_NE(kicker, 1) << "not the goalie";
}

TEST(HeliosPenalty, TakerScoresAgainstGoalieOnLine) {
  KnownPitch pitch;
  pitch.add_opponent(1, {51.5, 0.0});
  pitch.place_self({9.0, 0.0});
  pitch.place_ball({10.0, 0.0});
  pitch.world.unum = 10;
  pitch.set_shoot_out(PlayMode::kPenaltyTakenLeft);
  ASSERT_TRUE(is_penalty_taker(pitch.world));
  const auto scored = [&] { return pitch.world.game.mode == PlayMode::kPenaltyScoreLeft; };
  const int cycles = pitch.act_until(140, kPenalty, scored);
  EXPECT_TRUE(scored()) << cycles << " " << pitch.world.ball.position.x;
}

TEST(HeliosPenalty, TakerWaitsBehindBallDuringSetup) {
  KnownPitch pitch;
  pitch.place_self({4.0, 3.0});
  pitch.place_ball({10.0, 0.0});
  pitch.world.unum = 10;
  pitch.set_shoot_out(PlayMode::kPenaltySetupLeft);
  for (int i = 0; i < 50; ++i) pitch.act(kPenalty);
  EXPECT_LT(pitch.world.ball.dist_from_self, 1.3);
  EXPECT_LT(distance(pitch.world.ball.position, {10.0, 0.0}), 0.05) << "untouched";
}

TEST(HeliosPenalty, GoalieTakesPositionAndOthersWait) {
  KnownPitch goalie;
  goalie.make_goalie();
  goalie.place_self({-44.0, 5.0});
  goalie.place_ball({-10.0, 0.0});
  goalie.set_shoot_out(PlayMode::kPenaltySetupRight);
  goalie.world.game.penalty.field_side = Side::kLeft;
  for (int i = 0; i < 50; ++i) goalie.act(kPenalty);

  EXPECT_LT(distance(goalie.world.self.position, {-50.5, 0.0}), 1.5);
  KnownPitch waiting;
  waiting.world.unum = 5;
  waiting.set_shoot_out(PlayMode::kPenaltySetupLeft);
  waiting.place_self({20.0, 0.0});
  for (int i = 0; i < 60; ++i) waiting.act(kPenalty);

  EXPECT_LT(waiting.world.self.position.length(), 9.15);
}

TEST(HeliosPenalty, FailsOutsideShootOut) {
  KnownPitch pitch;
  pitch.act(kPenalty);
  EXPECT_EQ(pitch.counts(PlayerAction::kHeliosPenalty).failed, 1);
}

TEST(ShootOutView, RotatesSoThatTakerAttacksRight) {
  KnownPitch pitch;
  pitch.place_self({-12.0, 1.0}, 180.0, {-0.3, 0.0});
  pitch.place_ball({-13.0, 1.0}, {-0.5, 0.1});
  pitch.add_opponent(1, {-51.0, -2.0}, 0.0);
  pitch.set_shoot_out(PlayMode::kPenaltyTakenLeft);
  EXPECT_FALSE(needs_shoot_out_view(pitch.world)) << "their goal is in use";

  pitch.world.game.penalty.field_side = Side::kLeft;
  ASSERT_TRUE(needs_shoot_out_view(pitch.world));

  const player::WorldModel view = rotated(pitch.world);
  EXPECT_EQ(view.self.position, (Vec2{12.0, -1.0}));
  EXPECT_NEAR(view.self.body.degrees(), 0.0, 1e-9);
  EXPECT_EQ(view.ball.velocity, (Vec2{0.5, -0.1}));
  EXPECT_EQ(view.opponents[0].position, (Vec2{51.0, 2.0}));
  EXPECT_NEAR((view.ball.angle_from_self - view.self.body).degrees(),
              (pitch.world.ball.angle_from_self - pitch.world.self.body).degrees(), 1e-9);

  pitch.set_shoot_out(PlayMode::kPenaltyTakenRight);
  EXPECT_TRUE(needs_shoot_out_view(pitch.world)) << "we defend the goal on the right";
}

void hear(player::WorldModel& world, int unum, const player::SayMessage& said) {
  player::HeardMessage message;
  message.time = world.game.time;
  message.side = world.our_side;
  message.unum = unum;
  EXPECT_TRUE(append_say_message(said, world.server(), message.text));
  world.heard.push_back(message);
}

TEST(BhvDoHeardPassRecieve, RunsToAnnouncedPointAndContinues) {
  KnownPitch pitch;
  pitch.place_ball({-30.0, 0.0});
  pitch.world.ball.vel_count = 3;
  const Vec2 point{12.0, -9.0};
  hear(pitch.world, 4, player::SayPass{7, point, {{-29.0, 0.0}, {1.5, 0.0}}});
  PlayerActions reply;
  reply.add_actions()->mutable_turn()->set_relative_direction(120.0F);
  pitch.act(reply);
  EXPECT_EQ(pitch.report.heard_pass, 1) << "automatically";
  ASSERT_EQ(pitch.memory.intention.kind, player::Intention::Kind::kReceive);

  pitch.world.heard.clear();
  const double before = distance(pitch.world.self.position, point);
  for (int i = 0; i < 5; ++i) pitch.act(reply);

  EXPECT_GT(pitch.report.intention, 2);
  EXPECT_LT(distance(pitch.world.self.position, point), before - 1.0);
}

TEST(BhvDoHeardPassRecieve, FailsForOtherReceiver) {
  KnownPitch pitch;
  hear(pitch.world, 4, player::SayPass{8, {12.0, -9.0}, {{0.0, 0.0}, {1.5, 0.0}}});
  pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_bhv_do_heard_pass_recieve(); });
  EXPECT_EQ(pitch.counts(PlayerAction::kBhvDoHeardPassRecieve).failed, 1);
}

TEST(HeliosCommunication, SaysVisibleBallAndPlayers) {
  KnownPitch pitch;
  pitch.place_ball({5.0, 0.0}, {1.0, 0.0});
  pitch.add_opponent(4, {8.0, 1.0});
  pitch.add_teammate(9, {10.0, -10.0});
  for (player::PlayerState& player : pitch.world.opponents)
    player.seen_pos_count = player.unum_count = 0;
  pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_helios_communication(); });

  ASSERT_NE(pitch.sent<soccer::Say>(), nullptr);
  std::string_view text = pitch.sent<soccer::Say>()->text;
  const auto message = player::parse_say_message(text, pitch.world.server());
  ASSERT_TRUE(message);

  const auto* said = std::get_if<player::SayBallPlayer>(&*message);
  ASSERT_NE(said, nullptr);
  EXPECT_NEAR(said->ball.position.x, 6.0, 0.11) << "predicted position in the next cycle";
  EXPECT_EQ(said->player.number, 15);
}

TEST(HeliosCommunication, DirectsAttentionToTeammateAtBall) {
  KnownPitch pitch;
  pitch.place_ball({20.0, 10.0});
  pitch.add_teammate(9, {20.5, 10.0});
  pitch.add_teammate(3, {-20.0, 10.0});
  pitch.act([](PlayerActions&) {});
  ASSERT_NE(pitch.sent<soccer::AttentionTo>(), nullptr) << "by default";
  EXPECT_EQ(pitch.sent<soccer::AttentionTo>()->unum, 9);
}

TEST(HeliosBasicOffensive, ExecutesDefaultPlanWithBall) {
  KnownPitch pitch;
  pitch.place_ball({0.6, 0.0});
  pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_helios_basic_offensive(); });
  EXPECT_EQ(pitch.counts(PlayerAction::kHeliosBasicOffensive).done, 1);
  EXPECT_NE(pitch.sent<soccer::Kick>(), nullptr);
}

}  // namespace
}  // namespace cls::proxy
