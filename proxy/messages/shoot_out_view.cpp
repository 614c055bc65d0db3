// Rotating all positions, velocities and directions by 180 degrees.
#include "proxy/messages/shoot_out_view.h"

#include "player/estimates/estimates.h"

namespace cls::proxy {
namespace {

using soccer::AngleDeg;
using soccer::Vec2;

void rotate(Vec2& v) { v = -v; }
void rotate(AngleDeg& angle) { angle = angle + 180.0; }

template <typename... Values>
void rotate_all(Values&... values) {
  (rotate(values), ...);
}

void rotate_player(player::PlayerState& player) {
  rotate_all(player.position, player.velocity, player.seen_position, player.seen_velocity,
             player.heard_position, player.body, player.face, player.point_direction,
             player.angle_from_self, player.angle_from_ball);
}

}  // namespace

bool needs_shoot_out_view(const player::WorldModel& world) {
  const player::PenaltyState& penalty = world.game.penalty;
  if (!soccer::is_penalty_mode(world.game.mode)) return false;
  if (penalty.field_side == soccer::Side::kNeutral) return false;
  const bool at_our_side = penalty.field_side == world.our_side;
  const bool we_take = penalty.taker == world.our_side;
  return at_our_side == we_take;
}

player::WorldModel rotated(const player::WorldModel& world) {
  player::WorldModel view = world;
  player::SelfState& self = view.self;
  rotate_all(self.position, self.velocity, self.seen_position, self.seen_velocity, self.body,
             self.point_direction);

  player::BallState& ball = view.ball;
  rotate_all(ball.position, ball.velocity, ball.relative_position, ball.seen_position,
             ball.seen_relative_position, ball.seen_velocity, ball.heard_position,
             ball.heard_velocity, ball.angle_from_self);

  for (player::PlayerList* list : {&view.teammates, &view.opponents, &view.unknowns}) {
    for (player::PlayerState& player : *list) rotate_player(player);
  }
  for (player::InterceptPlan& plan : view.intercept.plans) rotate(plan.self_position);
  update_team_lines(view);
  return view;
}

}  // namespace cls::proxy
