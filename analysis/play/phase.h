// What kind of play a frame belongs to.
#pragma once

#include <cstdint>

#include "soccer/play_mode.h"

namespace cls::analysis {

/// Statistics count kLive unless they say otherwise (match-statistics 1.1).
enum class Phase : std::uint8_t {
  kLive,     ///< play_on
  kSet,      ///< a team may restart the game; the clock runs
  kStopped,  ///< after a goal or an offence, before kick-off, pauses
  kPenalty,  ///< shoot-out
  kOver,
};

Phase phase_of(soccer::PlayMode mode);

}  // namespace cls::analysis
