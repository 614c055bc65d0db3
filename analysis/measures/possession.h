// Possession by five definitions.
#pragma once

#include "analysis/play/flow.h"

namespace cls::analysis {

/// Frames per team, live frames except for `all_play`.
struct Possession {
  int live_frames = 0;
  /// Team of the last toucher in the live phase: the usual meaning of possession.
  PerTeam<int> last_touch = {};
  /// Team of the next toucher in the live phase.
  PerTeam<int> next_kicker = {};
  /// Team with a player that can kick; frames with such players in both teams count separately.
  PerTeam<int> at_feet = {};
  int at_feet_contested = 0;
  /// Team of the player that would reach the ball first (interception_time.h).
  PerTeam<int> fastest = {};
  /// As last_touch; during set plays the team that takes them.
  PerTeam<int> all_play = {};
};

Possession measure_possession(const Flow& flow);

/// Share of the left team; 0.5 if both are 0.
double left_share(const PerTeam<int>& frames);

}  // namespace cls::analysis
