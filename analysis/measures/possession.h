// Whose ball it was, by five definitions.
#pragma once

#include "analysis/play/flow.h"

namespace cls::analysis {

/// Frames by team. Live frames only, but for `all_play`.
struct Possession {
  int live_frames = 0;
  /// The team of the last toucher in the live phase: the usual meaning of possession.
  PerTeam<int> last_touch = {};
  /// The team that will touch next in the live phase.
  PerTeam<int> next_kicker = {};
  /// The team with a player who can kick at once; frames in which both have one are apart.
  PerTeam<int> at_feet = {};
  int at_feet_contested = 0;
  /// The team whose player would be first at the ball (interception_time.h).
  PerTeam<int> fastest = {};
  /// As last_touch, and while the game is being restarted the team that may do it.
  PerTeam<int> all_play = {};
};

Possession possession_of(const Flow& flow);

/// Left's part of the two; 0.5 if both are 0.
double left_share(const PerTeam<int>& frames);

}  // namespace cls::analysis
