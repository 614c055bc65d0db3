// Intention: continuation of a skill that takes several cycles.
#pragma once

#include "player/world/age.h"
#include "player/world/vocabulary.h"

namespace cls::player {

/// At most one at a time; it controls the following decisions until it is done or becomes invalid,
/// unless the Playmaker forbids it (docs/spec/proxy-behavior.md 2.5).
struct Intention {
  enum class Kind : unsigned char {
    kNone,
    kDribble,  ///< turn to `heading`, then dash after the ball
    kReceive,  ///< run to the receive point of an announced pass
  };

  Kind kind = Kind::kNone;
  Vec2 target{};
  AngleDeg heading{};  ///< of the dashes, global
  int turns = 0;       ///< remaining turns
  double dash_power = 0.0;
  int dashes = 0;   ///< remaining dashes; for kReceive remaining cycles
  GameTime last{};  ///< when it was created or last executed

  bool active() const { return kind != Kind::kNone; }
  void clear() { *this = Intention{}; }
};

}  // namespace cls::player
