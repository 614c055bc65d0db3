// Filling and searching the table.
#include "proxy/planner/reach.h"

#include <algorithm>

namespace cls::proxy {

ReachTable::ReachTable(const soccer::ServerParams& server, const soccer::PlayerType& type) {
  const double push = std::min(server.max_dash_power * type.dash_power_rate * type.effort_max,
                               server.player_accel_max);
  double speed = 0.0;
  for (std::size_t cycle = 1; cycle < run_.size(); ++cycle) {
    speed = std::min(speed * type.player_decay + push, type.player_speed_max);
    run_[cycle] = run_[cycle - 1] + speed;
  }
  settled_speed_ = speed;
}

int ReachTable::cycles(double distance) const {
  if (distance <= 0.0) return 0;
  return static_cast<int>(std::lower_bound(run_.begin(), run_.end(), distance) - run_.begin());
}

}  // namespace cls::proxy
