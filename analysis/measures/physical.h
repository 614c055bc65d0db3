// Physical load of players: distances, speeds and stamina.
#pragma once

#include <array>

#include "analysis/play/flow.h"

namespace cls::analysis {

/// Speed ranges in shares of the player type's top speed.
/// Standing, jogging, running and sprinting: below 20, 60 and 85 % of the top speed, and above.
constexpr std::size_t kSpeedBandCount = 4;

struct Movement {
  double live_distance = 0.0;                   ///< meters in live frames
  double other_distance = 0.0;                  ///< meters in all other frames
  double top_speed = 0.0;                       ///< meters per cycle, live frames
  std::array<int, kSpeedBandCount> bands = {};  ///< live frames

  double distance() const { return live_distance + other_distance; }
};

/// Excludes steps above 1.5 times the top speed, which are placements, and steps in which a player
/// connects or leaves.
PerPlayer<Movement> measure_movement(const Flow& flow);

struct Stamina {
  double used = 0.0;    ///< exact if the log has the capacity, otherwise estimated by the rules
  double lowest = 0.0;  ///< minimum stamina
  double last = 0.0;    ///< at the last frame
  double last_capacity = 0.0;       ///< -1: not in the log
  int exhausted_frames = 0;         ///< capacity exhausted, or stamina below the effort threshold
  int tired_frames = 0;             ///< stamina below the recovery threshold
  int lowered_recovery_frames = 0;  ///< recovery below its initial value
  int lowered_effort_frames = 0;    ///< effort below the player type's maximum
  int refills = 0;                  ///< second half, substitution, trainer
};

/// Counts all frames in which a player is connected (docs/spec/match-statistics.md 4.2). All zero
/// for versions 1 and 2.
PerPlayer<Stamina> measure_stamina(const gamelog::MatchRecord& record);

}  // namespace cls::analysis
