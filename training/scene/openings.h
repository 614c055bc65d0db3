// How open goal and teammates are from each own player's place, as HFO defines it, and how near
// opponents are.
#pragma once

#include <array>

#include "training/scene/cast.h"

namespace cls::training {

/// Angles in radians, in the scene's coordinates. Made once per scene for all observers: what a
/// player sees of the opponents does not depend on who asks.
class Openings {
 public:
  Openings(const Scene& scene, const Cast& cast);

  /// The widest part of the goal that no opponent covers, seen by the own player in `eye`.
  double to_goal(Seat eye) const { return of(eye).goal; }
  /// The widest part of a quarter turn around the direction to `mate` that no opponent nearer than
  /// `mate` covers, seen by the own player in `eye`.
  double to_teammate(Seat eye, Seat mate) const {
    return of(eye).teammates[static_cast<std::size_t>(mate)];
  }

  /// Meters from the own player in `eye` to the nearest opponent that is seen; infinity if none is.
  double nearest_opponent(Seat eye) const { return of(eye).nearest_opponent; }

 private:
  struct Eye {
    double goal;
    double nearest_opponent;
    std::array<double, soccer::kPlayersPerTeam> teammates;  ///< by seat, of the cast
  };

  const Eye& of(Seat eye) const { return eyes_[static_cast<std::size_t>(eye)]; }

  std::array<Eye, soccer::kPlayersPerTeam> eyes_;  ///< by own seat, of the cast
};

}  // namespace cls::training
