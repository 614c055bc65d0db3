// Neck, view, focus and arm actions: what comes into view.
#include <gtest/gtest.h>

#include "tests/proxy/support/wire_vector.h"
#include "tests/support/known_pitch.h"

namespace cls::proxy {
namespace {

using protos::PlayerAction;
using protos::PlayerActions;
using soccer::AngleDeg;
using soccer::Vec2;
using soccer::ViewWidth;
using tests::KnownPitch;
using tests::set;

/// Disables the proxy's own choice of view width.
void keep_view(PlayerActions& reply) { reply.add_actions()->mutable_view_synch(); }

/// A reply with one action, which `fill` makes, and the view width as it is.
template <typename Fill>
auto looking(Fill fill) {
  return [=](PlayerActions& reply) {
    keep_view(reply);
    fill(*reply.add_actions());
  };
}

TEST(NeckTurnToBall, BringsBallIntoView) {
  for (const double angle : {0.0, 60.0, -80.0, 110.0}) {
    KnownPitch pitch;
    pitch.place_ball(soccer::polar_degrees(15.0, angle), {0.5, 0.5});
    pitch.act(looking([](auto& action) { action.mutable_neck_turn_to_ball(); }));
    EXPECT_TRUE(pitch.sees(pitch.world.ball.position)) << angle;
  }
}

TEST(NeckTurnToBall, IncludesTurnAndDashOfSameCycle) {
  KnownPitch pitch;
  pitch.place_ball({3.0, 6.0});
  pitch.act([](PlayerActions& reply) {
    keep_view(reply);
    reply.add_actions()->mutable_turn()->set_relative_direction(150.0F);
    reply.add_actions()->mutable_neck_turn_to_ball();
  });
  EXPECT_NEAR(pitch.world.self.body.degrees(), 150.0, 0.1);
  EXPECT_TRUE(pitch.sees(pitch.world.ball.position));
}

TEST(NeckTurnToBallOrScan, TurnsToBallOnlyWhenStale) {
  const auto look = [](int threshold) {
    return looking([threshold](auto& action) {
      action.mutable_neck_turn_to_ball_or_scan()->set_count_threshold(threshold);
    });
  };
  KnownPitch pitch;
  pitch.place_ball({0.0, 20.0});
  pitch.act(look(-1));

  EXPECT_TRUE(pitch.sees(pitch.world.ball.position));

  // A fresh ball: the neck scans its whole range within a few cycles.
  std::array<bool, 24> seen{};
  for (int i = 0; i < 6; ++i) {
    pitch.act(look(0));
    for (int d = 0; d < 24; ++d) {
      seen[d] = seen[d] || pitch.sees(soccer::polar_degrees(10.0, d * 10.0 - 115.0));
    }
  }

  EXPECT_GE(std::ranges::count(seen, true), 22);
  pitch.world.ball.pos_count = 3;
  pitch.act(look(2));
  EXPECT_TRUE(pitch.sees(pitch.world.ball.position));
}

TEST(NeckScanField, TurnsToDirectionUnseenForLongest) {
  KnownPitch pitch;
  std::array<int, 24> unseen{};
  int longest = 0;

  for (int i = 0; i < 30; ++i) {
    pitch.act(looking([](auto& action) { action.mutable_neck_scan_field(); }));
    for (int d = 0; d < 24; ++d) {
      unseen[d] = pitch.sees(soccer::polar_degrees(10.0, d * 10.0 - 115.0)) ? 0 : unseen[d] + 1;
      if (i > 6) longest = std::max(longest, unseen[d]);
    }
  }

  EXPECT_LE(longest, 8) << "240 degrees with a cone of 60";
}

/// All players tracked and fresh, except one.
void fill_pitch(KnownPitch& pitch, int stale_opponent) {
  for (int unum = 1; unum <= 11; ++unum) {
    if (unum != 7) pitch.add_teammate(unum, {unum * 2.0 + 3.0, -6.0 + unum});
    const bool stale = unum == stale_opponent;
    pitch.add_opponent(unum, stale ? Vec2{2.0, -15.0} : Vec2{20.0, 2.0 * unum - 6.0}, 180.0,
                       stale ? 12 : 0);
  }
}

TEST(NeckScanPlayers, TurnsToStalePlayer) {
  KnownPitch pitch;
  fill_pitch(pitch, 9);
  pitch.act(looking([](auto& action) { action.mutable_neck_scan_players(); }));
  EXPECT_TRUE(pitch.sees({2.0, -15.0}));
}

TEST(NeckTurnToBallAndPlayer, ShowsBothWhenTheyFit) {
  KnownPitch pitch;
  pitch.place_ball({10.0, 0.0});
  pitch.add_opponent(5, {10.0, 8.0}, 180.0, 4);

  const auto look = [](int threshold) {
    return looking([threshold](auto& action) {
      auto& both = *action.mutable_neck_turn_to_ball_and_player();
      both.set_side(protos::RIGHT);
      both.set_uniform_number(5);
      both.set_count_threshold(threshold);
    });
  };

  pitch.act(look(2));
  EXPECT_TRUE(pitch.sees({10.0, 0.0}));
  EXPECT_TRUE(pitch.sees({10.0, 8.0}));

  // Too far apart: only the ball.
  KnownPitch apart;
  apart.place_ball({10.0, 0.0});
  apart.add_opponent(5, {-8.0, 8.0}, 180.0, 4);
  apart.act(look(2));

  EXPECT_TRUE(apart.sees({10.0, 0.0}));
  pitch.act([](PlayerActions& reply) {
    reply.add_actions()->mutable_neck_turn_to_ball_and_player()->set_uniform_number(3);
  });
  EXPECT_EQ(pitch.counts(PlayerAction::kNeckTurnToBallAndPlayer).failed, 1) << "no such player";
}

TEST(NeckTurnToPlayerOrScan, TurnsToPlayerOfNamedSide) {
  KnownPitch pitch;
  pitch.add_teammate(5, {5.0, 12.0}, 0.0, 6);
  pitch.add_opponent(5, {5.0, -12.0}, 0.0, 6);

  const auto look = [](protos::Side side) {
    return looking([side](auto& action) {
      auto& to = *action.mutable_neck_turn_to_player_or_scan();
      to.set_side(side);
      to.set_uniform_number(5);
      to.set_count_threshold(3);
    });
  };
  pitch.act(look(protos::LEFT));
  EXPECT_TRUE(pitch.sees({5.0, 12.0}));

  pitch.act(look(protos::RIGHT));
  EXPECT_TRUE(pitch.sees({5.0, -12.0}));
}

TEST(NeckTurnToGoalieOrScan, TurnsToStaleGoalie) {
  KnownPitch pitch;
  pitch.place_self({35.0, -15.0}, -60.0);
  pitch.add_opponent(1, {50.0, 1.0}, 180.0, 5);
  pitch.act(looking(
      [](auto& action) { action.mutable_neck_turn_to_goalie_or_scan()->set_count_threshold(2); }));
  EXPECT_TRUE(pitch.sees({50.0, 1.0}));
}

TEST(NeckTurnToLowConfTeammate, TurnsToStalestTeammateAhead) {
  KnownPitch pitch;
  pitch.add_teammate(9, {10.0, 12.0}, 0.0, 2);
  pitch.add_teammate(10, {8.0, -12.0}, 0.0, 7);
  pitch.add_teammate(2, {-15.0, 0.0}, 0.0, 20);
  pitch.act(looking([](auto& action) { action.mutable_neck_turn_to_low_conf_teammate(); }));
  EXPECT_TRUE(pitch.sees({8.0, -12.0}));
}

TEST(NeckTurnToPoint, BringsPointIntoView) {
  KnownPitch pitch;
  pitch.act([](PlayerActions& reply) {
    keep_view(reply);
    set(reply.add_actions()->mutable_neck_turn_to_point()->mutable_target_point(), {-4.0, -10.0});
  });
  EXPECT_TRUE(pitch.sees({-4.0, -10.0}));
}

TEST(NeckTurnToRelative, SetsNeckToAngle) {
  KnownPitch pitch;
  pitch.set_neck(-30.0);
  pitch.act([](PlayerActions& reply) {
    reply.add_actions()->mutable_neck_turn_to_relative()->set_angle(45.0F);
  });
  EXPECT_NEAR(pitch.world.self.neck.degrees(), 45.0, 0.5);
}

TEST(NeckOffensiveInterceptNeck, WatchesOpponentWithBall) {
  KnownPitch pitch;
  pitch.place_ball({8.0, 8.0});
  pitch.add_opponent(6, {8.5, 8.5}, 180.0, 1);
  pitch.act(looking([](auto& action) { action.mutable_neck_offensive_intercept_neck(); }));
  EXPECT_TRUE(pitch.sees({8.0, 8.0}));
  EXPECT_TRUE(pitch.sees({8.5, 8.5}));
}

TEST(TurnNeck, TurnsNeck) {
  KnownPitch pitch;
  pitch.act(
      [](PlayerActions& reply) { reply.add_actions()->mutable_turn_neck()->set_moment(-40.0F); });
  EXPECT_NEAR(pitch.world.self.neck.degrees(), -40.0, 1e-9);
}

TEST(BhvBodyNeckToPoint, FacesPointWithBodyAndNeck) {
  KnownPitch pitch;
  pitch.act([](PlayerActions& reply) {
    set(reply.add_actions()->mutable_bhv_body_neck_to_point()->mutable_point(), {-10.0, 10.0});
  });
  EXPECT_NEAR(pitch.world.self.body.degrees(), 135.0, 0.1);
  EXPECT_NEAR(pitch.world.self.face().degrees(), 135.0, 1.0);

  // Too fast for a full turn: the neck does the rest.
  pitch.place_self({}, 0.0, {0.4, 0.0});
  pitch.act([](PlayerActions& reply) {
    set(reply.add_actions()->mutable_bhv_body_neck_to_point()->mutable_point(), {0.4, 10.0});
  });

  EXPECT_NEAR(pitch.world.self.body.degrees(), 60.0, 0.1);
  EXPECT_NEAR(pitch.world.self.face().degrees(), 90.0, 1.0);
}

TEST(BhvBodyNeckToBall, FacesBall) {
  KnownPitch pitch;
  pitch.place_ball({-9.0, -9.0});
  pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_bhv_body_neck_to_ball(); });
  EXPECT_NEAR(pitch.world.self.face().degrees(), -135.0, 1.0);
}

TEST(BhvNeckBodyToPoint, TurnsBodyOnlyWhenNeckIsNotEnough) {
  KnownPitch pitch;
  const auto look = [](Vec2 point) {
    return [point](PlayerActions& reply) {
      auto& to = *reply.add_actions()->mutable_bhv_neck_body_to_point();
      set(to.mutable_point(), point);
      to.set_angle_buf(5.0F);
    };
  };

  pitch.act(look({0.5, 10.0}));
  EXPECT_NEAR(pitch.world.self.face().degrees(), 87.0, 5.0);
  EXPECT_GT(pitch.world.self.body.abs(), 80.0) << "inside the buffer: the body turns";
  pitch.place_self({}, 0.0);
  pitch.act(look({10.0, 10.0}));

  EXPECT_NEAR(pitch.world.self.body.degrees(), 0.0, 1e-9);
  EXPECT_NEAR(pitch.world.self.face().degrees(), 45.0, 1.0);
}

TEST(BhvNeckBodyToBall, BringsBallIntoView) {
  KnownPitch pitch;
  pitch.place_ball({-10.0, 2.0});
  pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_bhv_neck_body_to_ball(); });
  EXPECT_TRUE(pitch.sees({-10.0, 2.0}));
}

TEST(BhvScanField, SearchesLostBallAtLastPositionThenOpposite) {
  KnownPitch pitch;
  pitch.place_ball({0.0, 20.0});
  pitch.world.ball.seen_position = {0.0, 20.0};
  pitch.world.ball.pos_count = 20;
  const auto scan = [](PlayerActions& reply) { reply.add_actions()->mutable_bhv_scan_field(); };
  pitch.act(scan);
  EXPECT_TRUE(pitch.sees({0.0, 20.0}));
  EXPECT_EQ(pitch.world.self.view_width, ViewWidth::kWide);
  pitch.act(scan);
  EXPECT_TRUE(pitch.sees({0.0, -20.0}));
}

TEST(BhvScanField, TurnsWhenBallIsKnownOrSelfIsNot) {
  KnownPitch pitch;
  const auto scan = [](PlayerActions& reply) { reply.add_actions()->mutable_bhv_scan_field(); };
  pitch.act(scan);
  EXPECT_NEAR(pitch.world.self.body.degrees(), 120.0, 0.1) << "mean of 60 and 180 degrees";
  pitch.world.self.pos_count = player::kNever;
  pitch.act(scan);
  EXPECT_NEAR(pitch.world.self.body.degrees(), 180.0, 0.1);
}

TEST(BhvEmergency, OverridesBodyAction) {
  KnownPitch pitch;
  pitch.world.self.pos_count = player::kNever;
  pitch.act([](PlayerActions& reply) {
    reply.add_actions()->mutable_dash()->set_power(50.0F);
    reply.add_actions()->mutable_bhv_emergency();
  });
  ASSERT_NE(pitch.sent<soccer::Turn>(), nullptr);
  EXPECT_DOUBLE_EQ(pitch.sent<soccer::Turn>()->moment, 60.0);
  EXPECT_EQ(pitch.world.self.view_width, ViewWidth::kWide);
}

TEST(ViewActions, SetWidth) {
  KnownPitch pitch;
  pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_view_wide(); });
  EXPECT_EQ(pitch.world.self.view_width, ViewWidth::kWide);
  pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_view_normal(); });
  EXPECT_EQ(pitch.world.self.view_width, ViewWidth::kNormal);

  pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_view_synch(); });
  EXPECT_EQ(pitch.world.self.view_width, ViewWidth::kNarrow);
  pitch.act([](PlayerActions& reply) {
    reply.add_actions()->mutable_view_change_width()->set_view_width(protos::WIDE);
  });

  EXPECT_EQ(pitch.world.self.view_width, ViewWidth::kWide);
  pitch.act([](PlayerActions& reply) {
    reply.add_actions()->mutable_change_view()->set_view_width(protos::NORMAL);
  });

  EXPECT_EQ(pitch.world.self.view_width, ViewWidth::kNormal);
  pitch.act([](PlayerActions& reply) {
    reply.add_actions()->mutable_change_view()->set_view_width(static_cast<protos::ViewWidth>(9));
  });
  EXPECT_EQ(pitch.counts(PlayerAction::kChangeView).failed, 1);
}

TEST(FocusMoveToPoint, MovesFocusToPoint) {
  KnownPitch pitch;
  pitch.act([](PlayerActions& reply) {
    keep_view(reply);
    reply.add_actions()->mutable_dash()->set_power(100.0F);
    reply.add_actions()->mutable_turn_neck()->set_moment(30.0F);
    set(reply.add_actions()->mutable_focus_move_to_point()->mutable_target_point(), {15.0, 5.0});
  });
  EXPECT_LT(distance(pitch.focus_point(), {15.0, 5.0}), 0.02);
}

TEST(FocusMoveToPoint, StaysInsideViewCone) {
  KnownPitch pitch;
  pitch.act([](PlayerActions& reply) {
    keep_view(reply);
    set(reply.add_actions()->mutable_focus_move_to_point()->mutable_target_point(), {0.0, 10.0});
  });
  // The edge of the cone is at 30 degrees; its nearest point is 10 sin 30 away.
  EXPECT_LT(distance(pitch.focus_point(), soccer::polar_degrees(5.0, 30.0)), 0.02);
}

TEST(FocusReset, MovesFocusToAgent) {
  KnownPitch pitch;
  pitch.set_focus(12.0, 20.0);
  pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_focus_reset(); });
  EXPECT_NEAR(pitch.world.self.focus_distance, 0.0, 1e-9);
  EXPECT_NEAR(pitch.world.self.focus_direction.degrees(), 0.0, 1e-9);
}

TEST(Focus, FollowsBallByDefault) {
  KnownPitch pitch;
  pitch.place_ball({12.0, 4.0}, {0.5, 0.2});
  pitch.act(looking([](auto& action) { action.mutable_neck_turn_to_ball(); }));
  EXPECT_LT(distance(pitch.focus_point(), pitch.world.ball.position), 0.02);
}

TEST(PointTo, PointsArmAtPoint) {
  KnownPitch pitch;
  pitch.place_self({1.0, 2.0}, 70.0);
  pitch.act([](PlayerActions& reply) {
    auto& point = *reply.add_actions()->mutable_point_to();
    point.set_x(11.0F);
    point.set_y(2.0F);
  });

  ASSERT_NE(pitch.sent<soccer::PointTo>(), nullptr);
  EXPECT_NEAR(pitch.sent<soccer::PointTo>()->distance, 10.0, 0.01);
  EXPECT_NEAR(pitch.sent<soccer::PointTo>()->direction, -70.0, 0.01) << "off the face";

  pitch.roll(5);
  pitch.act([](PlayerActions& reply) { reply.add_actions()->mutable_point_to_of(); });
  EXPECT_NE(pitch.sent<soccer::PointToOff>(), nullptr);
}

}  // namespace
}  // namespace cls::proxy
