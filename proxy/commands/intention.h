// What a skill that needs several cycles means to do next.
#pragma once

#include "proxy/world/age.h"
#include "soccer/angle.h"
#include "soccer/geometry.h"

namespace cls::proxy {

/// At most one at a time; it takes over the following decisions until it is done or no longer makes
/// sense, unless the Playmaker forbids it (proxy behaviour 2.5).
struct Intention {
  enum class Kind : unsigned char {
    kNone,
    kDribble,  ///< turn to `heading`, then dash after the ball
    kReceive,  ///< to the place of an announced pass
  };

  Kind kind = Kind::kNone;
  soccer::Vec2 target;
  soccer::AngleDeg heading;  ///< of the dashes; global
  int turns = 0;             ///< turns still to do
  double dash_power = 0.0;
  int dashes = 0;  ///< dashes still to do; for kReceive cycles of patience
  GameTime last;   ///< when it was made or last carried on

  bool active() const { return kind != Kind::kNone; }
  void clear() { *this = Intention{}; }
};

}  // namespace cls::proxy
