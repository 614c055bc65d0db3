// How near opponents are to getting at a ball in the next few cycles.
#pragma once

#include "proxy/world/fixed_list.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// The opponents close enough to matter to a ball at our feet. Make it once per decision.
class Threats {
 public:
  explicit Threats(const WorldModel& world);

  bool empty() const { return near_.empty(); }
  /// Metres by which the nearest opponent, dashing as it can, misses kicking a ball that is at
  /// `ball` in `cycles` (0 to 3) cycles; negative when it gets it.
  double kick_gap(soccer::Vec2 ball, int cycles) const;
  /// Cost of leaving the ball there: 600 in somebody's kickable area as he moves now, 300 within
  /// his tackle, 150 where a dash brings him to it, 0 otherwise.
  double cost(soccer::Vec2 ball, int cycles) const;
  /// Distance to the nearest opponent as he moves by himself; 1000 when none is near.
  double nearest(soccer::Vec2 ball, int cycles) const;

 private:
  static constexpr int kCycles = 4;
  struct Opponent {
    soccer::Vec2 places[kCycles];  ///< by cycles from now, coasting
    double reach[kCycles];         ///< what dashing adds
    double kickable_area;
    soccer::Vec2 body;  ///< unit vector; zero when the body is not known
    bool lying;
  };
  FixedList<Opponent, 22> near_;
  double tackle_dist_;
  double tackle_width_;

  bool can_tackle(const Opponent& opponent, soccer::Vec2 relative) const;
};

}  // namespace cls::proxy
