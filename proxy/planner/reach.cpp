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
  // From rest nobody is quicker than at his settled speed all the way.
  std::size_t cycle = static_cast<std::size_t>(std::min(distance / settled_speed_, 1.0 * kCycles));
  while (cycle < run_.size() && run_[cycle] < distance) ++cycle;
  return static_cast<int>(cycle);
}

}  // namespace cls::proxy
