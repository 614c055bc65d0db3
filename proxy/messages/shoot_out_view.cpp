// Half a turn of everything that has a place or a direction.
#include "proxy/messages/shoot_out_view.h"

#include "proxy/estimates/team_lines.h"

namespace cls::proxy {
namespace {

using soccer::AngleDeg;
using soccer::Vec2;

void turn(Vec2& v) { v = -v; }
void turn(AngleDeg& angle) { angle = angle + 180.0; }

template <typename... Values>
void turn_all(Values&... values) {
  (turn(values), ...);
}

void turn_player(PlayerState& player) {
  turn_all(player.position, player.velocity, player.seen_position, player.seen_velocity,
           player.heard_position, player.body, player.face, player.point_direction,
           player.angle_from_self, player.angle_from_ball);
}

}  // namespace

bool turned_for_shoot_out(const WorldModel& world) {
  const PenaltyState& penalty = world.game.penalty;
  if (!soccer::is_penalty_mode(world.game.mode)) return false;
  if (penalty.field_side == soccer::Side::kNeutral) return false;
  const bool at_our_side = penalty.field_side == world.our_side;
  const bool we_take = penalty.taker == world.our_side;
  return at_our_side == we_take;
}

WorldModel turned(const WorldModel& world) {
  WorldModel view = world;
  SelfState& self = view.self;
  turn_all(self.position, self.velocity, self.seen_position, self.seen_velocity, self.body,
           self.point_direction);
  BallState& ball = view.ball;
  turn_all(ball.position, ball.velocity, ball.relative_position, ball.seen_position,
           ball.seen_relative_position, ball.seen_velocity, ball.heard_position,
           ball.heard_velocity, ball.angle_from_self);
  for (PlayerList* list : {&view.teammates, &view.opponents, &view.unknowns}) {
    for (PlayerState& player : *list) turn_player(player);
  }
  for (InterceptPlan& plan : view.intercept.plans) turn(plan.self_position);
  draw_lines(view);
  return view;
}

}  // namespace cls::proxy
