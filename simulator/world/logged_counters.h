// Counters of commands, as players and as logs have them.
#pragma once

#include "gamelog/record/frame.h"
#include "simulator/world/player.h"

namespace cls::simulator {

inline Counters counters_of(const gamelog::CommandCounts& c) {
  return {c.kick,        c.dash, c.turn,   c.catches, c.move,        c.turn_neck,
          c.change_view, c.say,  c.tackle, c.pointto, c.attentionto, c.change_focus};
}

inline gamelog::CommandCounts counts_of(const Counters& c) {
  return {c.kick,        c.dash, c.turn,   c.catch_ball, c.move,         c.turn_neck,
          c.change_view, c.say,  c.tackle, c.point_to,   c.attention_to, c.change_focus};
}

}  // namespace cls::simulator
