// Play modes by phase.
#include "analysis/play/phase.h"

namespace cls::analysis {

Phase phase_of(soccer::PlayMode mode) {
  if (mode == soccer::PlayMode::kPlayOn) return Phase::kLive;
  if (mode == soccer::PlayMode::kTimeOver) return Phase::kOver;
  if (soccer::is_set_play(mode)) return Phase::kSet;
  if (soccer::is_penalty_mode(mode)) return Phase::kPenalty;
  return Phase::kStopped;
}

}  // namespace cls::analysis
