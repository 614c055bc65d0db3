// Builds a reply: one function per action that the simple team uses.
#pragma once

#include "proto/playmaker.pb.h"
#include "soccer/geometry.h"

namespace cls::mock_server {

/// Appends to a reply. The proxy tries body actions in sequence until one succeeds and executes all
/// neck and view actions, so the order of calls is the order of preference.
class ActionList {
 public:
  explicit ActionList(protos::PlayerActions& actions) : actions_(actions) {}

  // With the ball. Speeds in meters per cycle.
  void smart_kick(soccer::Vec2 target, double speed, double min_speed, int kicks);
  void dribble(soccer::Vec2 target, double dash_power, int dashes);
  void clear_ball();
  void hold_ball(soccer::Vec2 face);

  // Without the ball.
  void intercept(soccer::Vec2 face);
  void go_to(soccer::Vec2 target, double within, double dash_power);
  void tackle_towards(soccer::Vec2 target, double min_probability);
  void catch_ball();
  void turn_to_ball();
  void turn_to(soccer::Vec2 target);
  void move_to(soccer::Vec2 target);
  void stand_for_kick_off(soccer::Vec2 target);
  void search_ball();

  // Neck and view.
  void watch_ball();
  void watch_ball_or_scan(int ball_age);
  void watch_goalie_or_scan();
  void scan();

 private:
  protos::PlayerAction& add() { return *actions_.add_actions(); }

  protos::PlayerActions& actions_;
};

}  // namespace cls::mock_server
