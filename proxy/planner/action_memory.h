// State of an agent's actions between decisions.
#pragma once

#include <string>

#include "proxy/commands/intention.h"
#include "proxy/world/view_cone.h"

namespace cls::proxy {

/// Goalie free kick: whether and when the goalie moved with the caught ball.
struct GoalieKickMemory {
  bool moved = false;
  int move_cycle = 0;
};

/// One per agent; a plain value.
struct ActionMemory {
  ViewMemory view;
  Intention intention;
  bool recovering = false;  ///< saves stamina until it has recovered (normal_dash_power)
  GoalieKickMemory goalie_kick;
  int ball_since =
      -1;  ///< cycle since which the agent has had the ball in play; -1: does not have it
  std::string debug;  ///< this decision's debug lines (debug_log.h)
};

}  // namespace cls::proxy
