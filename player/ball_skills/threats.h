// Threats to the ball by nearby opponents in the next cycles.
#pragma once

#include "base/fixed_list.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Opponents close to a ball controlled by the agent. Create once per decision.
class Threats {
 public:
  explicit Threats(const WorldModel& world);

  /// Cost of a ball position: 600 in the kickable area of a coasting opponent, 300 in its tackle
  /// area, 150 where a dash reaches it, 0 otherwise.
  double cost(soccer::Vec2 ball, int cycles) const;
  /// Distance to the nearest coasting opponent; 1000 if none is near.
  double nearest(soccer::Vec2 ball, int cycles) const;

 private:
  static constexpr int kCycles = 4;
  struct Opponent {
    soccer::Vec2 positions[kCycles];  ///< by cycles from now, coasting
    double reach[kCycles];            ///< additional distance by dashing
    double kickable_area;
    soccer::Vec2 body;  ///< unit vector; zero if unknown
    bool tackling;
  };
  base::FixedList<Opponent, 22> near_;
  double tackle_dist_;
  double tackle_width_;

  bool can_tackle(const Opponent& opponent, soccer::Vec2 relative) const;
};

}  // namespace cls::player
