// What an agent's actions remember from one decision to the next.
#pragma once

#include "proxy/intention.h"
#include "proxy/sight_memory.h"

namespace cls::proxy {

/// One per agent; a plain value.
struct ActionMemory {
  SightMemory sight;
  Intention intention;
  bool recovering = false;  ///< saves stamina until it is back (normal_dash_power)
};

}  // namespace cls::proxy
