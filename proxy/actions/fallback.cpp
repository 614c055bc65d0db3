// Actions chosen by the proxy.
#include "proxy/actions/fallback.h"

#include "player/movement/home_positions.h"

namespace cls::proxy {
namespace {

constexpr float kHomeDistance = 1.0F;
constexpr float kRunningPower = 70.0F;

void go_home(const player::WorldModel& world, protos::PlayerActions& out) {
  const soccer::Vec2 home = own_home_position(world);
  protos::Body_GoToPoint& go = *out.add_actions()->mutable_body_go_to_point();
  go.mutable_target_point()->set_x(static_cast<float>(home.x));
  go.mutable_target_point()->set_y(static_cast<float>(home.y));
  go.set_distance_threshold(kHomeDistance);
  go.set_max_dash_power(kRunningPower);
}

}  // namespace

void choose_fallback_actions(const player::WorldModel& world, protos::PlayerActions& out) {
  out.Clear();
  const player::InterceptTable& table = world.intercept;
  const bool may_touch = !is_set_play_of(world.game, world.their_side());
  if (world.self.kickable) {
    out.add_actions()->mutable_body_clear_ball();
  } else if (may_touch && table.self_steps < player::kNever &&
             table.self_steps <= table.first_teammate_steps) {
    out.add_actions()->mutable_body_intercept();
  } else {
    go_home(world, out);
    out.add_actions()->mutable_body_turn_to_ball();
  }
  out.add_actions()->mutable_neck_turn_to_ball_or_scan();
}

}  // namespace cls::proxy
