// What actions of several sets need in order to have an effect, and the action without one.
#pragma once

#include "training/actions/action_set.h"

namespace cls::training {

inline bool has_ball(const PointOfView& view) { return can_kick(view.scene, view.self); }
inline bool tackle_reaches(const PointOfView& view) {
  return tackle_chance(view.scene, view.self) > 0.0;
}
inline bool catch_reaches(const PointOfView& view) { return can_catch(view.scene, view.self); }

inline bool sees_ball(const PointOfView& view) { return view.scene.ball_seen; }

inline PlayerCommand nothing(const PointOfView&, const float*) { return stand(); }
inline PlayerCommand shoot_at_goal(const PointOfView& view, const float*) {
  return shoot(view.scene, view.self);
}
inline PlayerCommand catch_now(const PointOfView& view, const float*) {
  return catch_ball(view.scene, view.self);
}

}  // namespace cls::training
