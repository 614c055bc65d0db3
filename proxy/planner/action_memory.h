// What an agent's actions remember from one decision to the next.
#pragma once

#include <string>

#include "proxy/commands/intention.h"
#include "proxy/world/sight_memory.h"

namespace cls::proxy {

/// The goalie's free kick: whether it moved with the ball in hand, and when.
struct GoalieKickMemory {
  bool moved = false;
  int move_cycle = 0;
};

/// One per agent; a plain value.
struct ActionMemory {
  SightMemory sight;
  Intention intention;
  bool recovering = false;  ///< saves stamina until it is back (normal_dash_power)
  GoalieKickMemory goalie_kick;
  int ball_since = -1;  ///< cycle from which on the agent has had the ball in play; -1: has not
  std::string debug;    ///< this decision's debug lines (debug_log.h)
};

}  // namespace cls::proxy
