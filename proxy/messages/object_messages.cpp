// Objects on the pitch, field by field.
#include "proxy/messages/object_messages.h"

#include "soccer/angle.h"

namespace cls::proxy {
namespace {

constexpr float f(double value) { return static_cast<float>(value); }
float degrees(soccer::AngleDeg angle) { return f(angle.degrees()); }

protos::CardType wire_card(soccer::Card card) {
  return card == soccer::Card::kRed      ? protos::RED
         : card == soccer::Card::kYellow ? protos::YELLOW
                                         : protos::NO_CARD;
}

protos::ViewWidth wire_width(soccer::ViewWidth width) {
  return width == soccer::ViewWidth::kNarrow   ? protos::NARROW
         : width == soccer::ViewWidth::kNormal ? protos::NORMAL
                                               : protos::WIDE;
}

float angle_from_ball(const BallState& ball) { return degrees(ball.angle_from_self + 180.0); }

// What Self and Player say alike about the agent.
template <typename Message>
void fill_own(const WorldModel& world, Message& out) {
  const SelfState& self = world.self;
  fill(self.position, *out.mutable_position());
  fill(self.seen_position, *out.mutable_seen_position());
  fill({}, *out.mutable_heard_position());
  fill(self.velocity, *out.mutable_velocity());
  fill(self.seen_velocity, *out.mutable_seen_velocity());
  out.set_pos_count(self.pos_count);
  out.set_seen_pos_count(self.seen_pos_count);
  out.set_heard_pos_count(kNever);
  out.set_vel_count(self.vel_count);
  out.set_seen_vel_count(self.seen_vel_count);
  out.set_ghost_count(0);
  out.set_id(0);
  out.set_side(wire_side(world.our_side));
  out.set_uniform_number(world.unum);
  out.set_uniform_number_count(0);
  out.set_is_goalie(world.goalie);
  out.set_body_direction(degrees(self.body));
  out.set_body_direction_count(self.body_count);
  out.set_face_direction(degrees(self.face()));
  out.set_face_direction_count(self.body_count);
  out.set_point_to_direction(degrees(self.point_direction));
  out.set_point_to_direction_count(self.point_count);
  out.set_is_kicking(self.kicked);
  out.set_dist_from_ball(f(world.ball.dist_from_self));
  out.set_angle_from_ball(angle_from_ball(world.ball));
  out.set_ball_reach_steps(world.intercept.best_self_steps());
  out.set_is_tackling(self.tackling());
  out.set_type_id(self.type_id);
}

}  // namespace

protos::Side wire_side(soccer::Side side) {
  return side == soccer::Side::kLeft    ? protos::LEFT
         : side == soccer::Side::kRight ? protos::RIGHT
                                        : protos::UNKNOWN;
}

void fill(soccer::Vec2 vector, protos::RpcVector2D& out, const protos::RpcVector2D* known) {
  // Without the sign of zero, which a direction would show.
  const float x = f(vector.x) + 0.0F;
  const float y = f(vector.y) + 0.0F;
  // Much of a State is as in the cycle before, and directions are what costs most of it.
  if (out.x() == x && out.y() == y) return;
  out.set_x(x);
  out.set_y(y);
  if (known != nullptr && known->x() == x && known->y() == y) {
    out.set_dist(known->dist());
    out.set_angle(known->angle());
    return;
  }
  const soccer::Vec2 rounded{x, y};
  out.set_dist(f(rounded.length()));
  out.set_angle(rounded.is_zero() ? 0.0F : f(soccer::direction_degrees(rounded)));
}

void fill_self(const WorldModel& world, protos::Self& out) {
  const SelfState& self = world.self;
  fill_own(world, out);
  out.set_relative_neck_direction(degrees(self.neck));
  out.set_stamina(f(self.stamina));
  out.set_is_kickable(self.kickable);
  out.set_catch_probability(f(self.catch_probability));
  out.set_tackle_probability(f(self.tackle_probability));
  out.set_foul_probability(f(self.foul_probability));
  out.set_view_width(wire_width(self.view_width));
  out.set_kick_rate(f(self.kick_rate));
  out.set_recovery(f(self.recovery));
  out.set_stamina_capacity(f(self.capacity));
  out.set_card(wire_card(self.card));
  out.set_catch_time(self.catch_time);
  out.set_effort(f(self.effort));
  out.set_get_safety_dash_power(f(self.safety_dash_power));
}

void fill_self_as_player(const WorldModel& world, protos::Player& out) {
  const SelfState& self = world.self;
  fill_own(world, out);
  out.set_dist_from_self(0.0F);
  out.set_angle_from_self(0.0F);
  const double decay = world.self_type().player_decay;
  fill(self.position + self.velocity / (1.0 - decay), *out.mutable_inertia_final_point());
  out.set_body_count(self.body_count);
}

void fill_player(const PlayerState& player, double decay, const protos::Player* twin,
                 protos::Player& out) {
  const auto& known = twin != nullptr ? *twin : protos::Player::default_instance();
  fill(player.position, *out.mutable_position(), &known.position());
  fill(player.seen_position, *out.mutable_seen_position(), &known.seen_position());
  fill(player.heard_position, *out.mutable_heard_position(), &known.heard_position());
  fill(player.velocity, *out.mutable_velocity(), &known.velocity());
  fill(player.seen_velocity, *out.mutable_seen_velocity(), &known.seen_velocity());
  fill(inertia_final_point(player, decay), *out.mutable_inertia_final_point(),
       &known.inertia_final_point());
  out.set_pos_count(player.pos_count);
  out.set_seen_pos_count(player.seen_pos_count);
  out.set_heard_pos_count(player.heard_pos_count);
  out.set_vel_count(player.vel_count);
  out.set_seen_vel_count(player.seen_vel_count);
  out.set_ghost_count(player.ghost_count);
  out.set_dist_from_self(f(player.dist_from_self));
  out.set_angle_from_self(degrees(player.angle_from_self));
  out.set_id(player.id);
  out.set_side(wire_side(player.side));
  out.set_uniform_number(player.unum == 0 ? -1 : player.unum);
  out.set_uniform_number_count(player.unum_count);
  out.set_is_goalie(player.goalie);
  out.set_body_direction(degrees(player.body));
  out.set_body_direction_count(player.body_count);
  out.set_face_direction(degrees(player.face));
  out.set_face_direction_count(player.face_count);
  out.set_point_to_direction(degrees(player.point_direction));
  out.set_point_to_direction_count(player.point_count);
  out.set_is_kicking(player.kicking);
  out.set_dist_from_ball(f(player.dist_from_ball));
  out.set_angle_from_ball(degrees(player.angle_from_ball));
  out.set_ball_reach_steps(player.ball_reach_steps);
  out.set_is_tackling(player.tackling);
  out.set_type_id(player.type_id);
  out.set_body_count(player.body_count);
}

void fill_ball(const BallState& ball, protos::Ball& out) {
  fill(ball.position, *out.mutable_position());
  fill(ball.relative_position, *out.mutable_relative_position());
  fill(ball.seen_position, *out.mutable_seen_position());
  fill(ball.heard_position, *out.mutable_heard_position());
  fill(ball.velocity, *out.mutable_velocity());
  fill(ball.seen_velocity, *out.mutable_seen_velocity());
  fill(ball.heard_velocity, *out.mutable_heard_velocity());
  out.set_pos_count(ball.pos_count);
  out.set_seen_pos_count(ball.seen_pos_count);
  out.set_heard_pos_count(ball.heard_pos_count);
  out.set_vel_count(ball.vel_count);
  out.set_seen_vel_count(ball.seen_vel_count);
  out.set_heard_vel_count(ball.heard_vel_count);
  out.set_lost_count(ball.lost_count);
  out.set_ghost_count(ball.ghost_count);
  out.set_dist_from_self(f(ball.dist_from_self));
  out.set_angle_from_self(degrees(ball.angle_from_self));
}

}  // namespace cls::proxy
