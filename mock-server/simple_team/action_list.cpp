// Filling the action messages.
#include "mock-server/simple_team/action_list.h"

namespace cls::mock_server {
namespace {

void set_point(protos::RpcVector2D& vector, soccer::Vec2 point) {
  vector.set_x(static_cast<float>(point.x));
  vector.set_y(static_cast<float>(point.y));
}

}  // namespace

void ActionList::smart_kick(soccer::Vec2 target, double speed, double min_speed, int kicks) {
  auto& kick = *add().mutable_body_smart_kick();
  set_point(*kick.mutable_target_point(), target);
  kick.set_first_speed(static_cast<float>(speed));
  kick.set_first_speed_threshold(static_cast<float>(min_speed));
  kick.set_max_steps(kicks);
}

void ActionList::dribble(soccer::Vec2 target, double dash_power, int dashes) {
  auto& dribble = *add().mutable_body_dribble();
  set_point(*dribble.mutable_target_point(), target);
  dribble.set_distance_threshold(1.0F);
  dribble.set_dash_power(static_cast<float>(dash_power));
  dribble.set_dash_count(dashes);
  dribble.set_dodge(true);
}

void ActionList::clear_ball() { add().mutable_body_clear_ball(); }

void ActionList::hold_ball(soccer::Vec2 face) {
  auto& hold = *add().mutable_body_hold_ball();
  hold.set_do_turn(true);
  set_point(*hold.mutable_turn_target_point(), face);
  set_point(*hold.mutable_kick_target_point(), face);
}

void ActionList::intercept(soccer::Vec2 face) {
  auto& intercept = *add().mutable_body_intercept();
  set_point(*intercept.mutable_face_point(), face);
}

void ActionList::go_to(soccer::Vec2 target, double within, double dash_power) {
  auto& go = *add().mutable_body_go_to_point();
  set_point(*go.mutable_target_point(), target);
  go.set_distance_threshold(static_cast<float>(within));
  go.set_max_dash_power(static_cast<float>(dash_power));
}

void ActionList::tackle_towards(soccer::Vec2 target, double min_probability) {
  auto& tackle = *add().mutable_body_tackle_to_point();
  set_point(*tackle.mutable_target_point(), target);
  tackle.set_min_probability(static_cast<float>(min_probability));
}

void ActionList::catch_ball() { add().mutable_catch_(); }

void ActionList::turn_to_ball() { add().mutable_body_turn_to_ball()->set_cycle(1); }

void ActionList::turn_to(soccer::Vec2 target) {
  auto& turn = *add().mutable_body_turn_to_point();
  set_point(*turn.mutable_target_point(), target);
  turn.set_cycle(1);
}

void ActionList::move_to(soccer::Vec2 target) {
  auto& move = *add().mutable_move();
  move.set_x(static_cast<float>(target.x));
  move.set_y(static_cast<float>(target.y));
}

void ActionList::stand_for_kick_off(soccer::Vec2 target) {
  set_point(*add().mutable_bhv_before_kick_off()->mutable_point(), target);
}

void ActionList::search_ball() { add().mutable_bhv_neck_body_to_ball(); }

void ActionList::watch_ball() { add().mutable_neck_turn_to_ball(); }

void ActionList::watch_ball_or_scan(int ball_age) {
  add().mutable_neck_turn_to_ball_or_scan()->set_count_threshold(ball_age);
}

void ActionList::watch_goalie_or_scan() { add().mutable_neck_turn_to_goalie_or_scan(); }

void ActionList::scan() { add().mutable_neck_scan_field(); }

}  // namespace cls::mock_server
