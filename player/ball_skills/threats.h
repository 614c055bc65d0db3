// Threats to the ball by nearby opponents in the next cycles.
#pragma once

#include "base/fixed_list.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Opponents close to a ball controlled by the agent. Create once per decision.
class Threats {
 public:
  explicit Threats(const WorldModel& world);

  /// Cost of a ball position (ThreatCosts); 0 where no opponent threatens it.
  double cost(Vec2 ball, int cycles) const;
  /// Distance to the nearest coasting opponent; 1000 if none is near.
  double nearest(Vec2 ball, int cycles) const;

 private:
  static constexpr int kCycles = 4;
  struct Opponent {
    Vec2 positions[kCycles];  ///< by cycles from now, coasting
    double reach[kCycles];    ///< additional distance by dashing
    double kickable_area;
    Vec2 body;  ///< unit vector; zero if unknown
    bool tackling;
  };
  base::FixedList<Opponent, 22> near_;
  double tackle_dist_;
  double tackle_width_;

  bool can_tackle(const Opponent& opponent, Vec2 relative) const;
};

}  // namespace cls::player
