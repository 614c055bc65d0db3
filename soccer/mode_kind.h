// Play modes without regard to whose they are.
#pragma once

#include "soccer/play_mode.h"

namespace cls::soccer {

/// The left variant of a mode that has a side, the mode itself otherwise.
inline PlayMode kind_of(PlayMode mode) {
  return side(mode) == Side::kNeutral ? mode : for_side(mode, Side::kLeft);
}

}  // namespace cls::soccer
