// Actions that several sets have, and what actions need in order to have an effect.
#pragma once

#include "soccer/pitch.h"
#include "training/actions/action_set.h"
#include "training/skills/positions.h"

namespace cls::training {

inline const Column kPower = {"power", "1", 0, 100};
inline const Column kDirection = {"direction", "deg", -180, 180};

inline bool has_ball(const PointOfView& view) { return can_kick(view.scene, view.self); }
inline bool tackle_reaches(const PointOfView& view) {
  return tackle_chance(view.scene, view.self) > 0.0;
}
inline bool catch_reaches(const PointOfView& view) { return can_catch(view.scene, view.self); }
inline bool sees_ball(const PointOfView& view) { return view.scene.ball_seen; }

inline PlayerCommand nothing(const PointOfView&, const float*) { return stand(); }
inline PlayerCommand dash(const PointOfView&, const float* v) { return soccer::Dash{v[0], v[1]}; }
inline PlayerCommand turn(const PointOfView&, const float* v) { return soccer::Turn{v[0]}; }
inline PlayerCommand kick(const PointOfView&, const float* v) { return soccer::Kick{v[0], v[1]}; }
inline PlayerCommand tackle(const PointOfView&, const float* v) {
  return soccer::Tackle{v[0], false};
}
inline PlayerCommand catch_now(const PointOfView& view, const float*) {
  return catch_ball(view.scene, view.self);
}
inline PlayerCommand shoot_at_goal(const PointOfView& view, const float*) {
  return shoot(view.scene, view.self);
}
inline PlayerCommand face_ball(const PointOfView& view, const float*) {
  return face(view.scene, view.self, view.scene.ball);
}
inline PlayerCommand support(const PointOfView& view, const float*) {
  return go_to(view.scene, view.self, support_position(view), 1.0);
}
inline PlayerCommand guard(const PointOfView& view, const float*) {
  return go_to(view.scene, view.self, guard_position(view), 0.5);
}

}  // namespace cls::training
