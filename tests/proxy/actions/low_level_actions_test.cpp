// Actions that are server commands, with their effect on the server.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/proxy/coach/coached_match.h"

namespace cls::tests {
namespace {

using protos::PlayerActions;
using soccer::Side;
using soccer::Vec2;

/// During play_on: player 7 at the center facing +x, the ball far away, all other players on the
/// touch line.
struct InPlay : CoachedMatch {
  /// Players see their new positions.
  static constexpr int kUntilBelieved = 6;

  InPlay() : CoachedMatch(soccer::CoachRole::kOnlineCoach) {
    steps_until(soccer::PlayMode::kKickOffLeft);
    set_mode(soccer::PlayMode::kPlayOn);
    arrange([](simulator::World& world) {
      world.ball = {{30.0, 20.0}, {}, {}};
      for (std::size_t i = 0; i < world.players.size(); ++i) {
        put(world.players[i], {-50.0 + 4.0 * static_cast<double>(i), -36.0});
      }
      put(world.player(Side::kLeft, 7), {0.0, 0.0});
    });
    steps(kUntilBelieved);
  }

  static void put(simulator::Player& player, Vec2 position, double body_deg = 0.0) {
    player.position = position;
    player.velocity = {};
    player.body = player.pending_body = soccer::math::to_radians(body_deg);
  }
  void place_ball(Vec2 position) {
    arrange([=](simulator::World& world) { world.ball = {position, {}, {}}; });
    steps(kUntilBelieved);
  }
  /// One decision of that player, and the step that executes it.
  void act(Side side, int unum, const std::function<void(protos::PlayerAction&)>& fill) {
    play = [=](const proxy::PlayerAgent& player, PlayerActions& actions) {
      if (player.world().our_side == side && player.unum() == unum) fill(*actions.add_actions());
    };
    steps(1);
    play = nullptr;
    steps(1);
  }
  void act(const std::function<void(protos::PlayerAction&)>& fill) { act(Side::kLeft, 7, fill); }
  const simulator::Player& self() const { return world().player(Side::kLeft, 7); }
};

TEST(Dash, MovesPlayerInDirection) {
  InPlay match;
  match.act([](auto& action) {
    action.mutable_dash()->set_power(80.0F);
    action.mutable_dash()->set_relative_direction(90.0F);
  });
  EXPECT_GT(match.self().position.y, 0.1) << "to the right of the body";
  EXPECT_NEAR(match.self().position.x, 0.0, 0.01);
  EXPECT_LT(match.self().stamina.value, 8000.0);
}

TEST(Turn, TurnsTheBody) {
  InPlay match;
  match.act([](auto& action) { action.mutable_turn()->set_relative_direction(-75.0F); });
  EXPECT_NEAR(soccer::math::to_degrees(match.self().body), -75.0, 0.5);
}

TEST(Kick, AcceleratesBallInDirection) {
  InPlay match;
  match.place_ball({0.6, 0.0});
  match.act([](auto& action) {
    action.mutable_kick()->set_power(60.0F);
    action.mutable_kick()->set_relative_direction(90.0F);
  });
  EXPECT_GT(match.world().ball.position.y, 0.8);
  EXPECT_NEAR(match.world().ball.position.x, 0.6, 0.15);
}

TEST(Tackle, KicksBallAndFreezesPlayer) {
  InPlay match;
  match.place_ball({0.8, 0.0});
  match.act([](auto& action) { action.mutable_tackle()->set_power_or_dir(0.0F); });
  EXPECT_GT(match.world().ball.position.x, 1.5);
  EXPECT_GT(match.self().tackle_cycles, 0);
}

TEST(Catch, HoldsTheBall) {
  InPlay match;
  match.arrange([](simulator::World& world) {
    InPlay::put(world.player(Side::kLeft, 1), {-49.0, 0.0});
    world.ball = {{-48.2, 0.3}, {}, {}};
  });
  match.steps(1);
  match.act(Side::kLeft, 1, [](auto& action) { action.mutable_catch_(); });
  EXPECT_EQ(match.world().ball_catcher, soccer::slot_of(Side::kLeft, 1));
  EXPECT_EQ(match.world().mode, soccer::PlayMode::kFreeKickLeft);
  EXPECT_EQ(match.world_model(Side::kLeft, 1).game_mode_type(), protos::GoalieCatch_);
}

TEST(Move, SetsPositionBeforeKickOff) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    InPlay match;
    match.set_mode(soccer::PlayMode::kBeforeKickOff);
    match.act(side, 7, [](auto& action) {
      action.mutable_move()->set_x(-12.0F);
      action.mutable_move()->set_y(3.0F);
    });
    const double sign = side == Side::kLeft ? 1.0 : -1.0;
    EXPECT_NEAR(match.world().player(side, 7).position.x, sign * -12.0, 1e-6);
    EXPECT_NEAR(match.world().player(side, 7).position.y, sign * 3.0, 1e-6);
  }
}

TEST(AttentionTo, SetsAndClearsAttention) {
  InPlay match;
  // The agent's own choice must not be mistaken for the effect of the action.
  match.act([](auto& action) {
    action.mutable_attention_to()->set_side(protos::LEFT);
    action.mutable_attention_to()->set_unum(3);
  });

  EXPECT_EQ(match.self().attention, soccer::slot_of(Side::kLeft, 3));
  match.play = [](const proxy::PlayerAgent& player, PlayerActions& actions) {
    if (player.world().our_side == Side::kLeft && player.unum() == 7) {
      actions.add_actions()->mutable_attention_to_of();
    }
  };

  match.steps(3);
  EXPECT_EQ(match.self().attention, simulator::kNoPlayer);
}

TEST(Say, IsHeardByListeningTeammate) {
  InPlay match;
  match.arrange([](simulator::World& world) {
    InPlay::put(world.player(Side::kLeft, 9), {10, 5});
  });

  match.play = [](const proxy::PlayerAgent& player, PlayerActions& actions) {
    if (player.world().our_side != Side::kLeft) return;
    if (player.unum() == 9) {
      auto& attention = *actions.add_actions()->mutable_attention_to();
      attention.set_side(protos::LEFT);
      attention.set_unum(7);
    }

    if (player.unum() != 7) return;
    auto& pass = *actions.add_actions()->mutable_say()->mutable_pass_message();
    pass.set_receiver_uniform_number(9);
    pass.mutable_receiver_point()->set_x(20.0F);
    pass.mutable_receiver_point()->set_y(6.0F);
    pass.mutable_ball_position()->set_x(1.0F);
    pass.mutable_ball_velocity()->set_x(2.0F);
  };

  const auto heard = [&] {
    const auto& all = match.player(Side::kLeft, 9).world().heard;
    return std::ranges::any_of(all, [](const player::HeardMessage& message) {
      return message.unum == 7 && message.text.starts_with("p");
    });
  };

  for (int i = 0; i < 5 && !heard(); ++i) match.steps(1);
  EXPECT_TRUE(heard());
}

}  // namespace
}  // namespace cls::tests
