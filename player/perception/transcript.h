// Replays a transcript of a player's messages through a world model.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "player/world/world_model.h"

namespace cls::player {

/// Called at each decision with the world model after update_derived().
using OnDecision = std::function<void(const WorldModel& world)>;

/// An invalid line or a message that does not parse.
struct TranscriptError {
  std::size_t line = 0;  ///< from 1
  std::string what;
};

struct TranscriptReplay {
  WorldModel world;                     ///< final state; unum 0 if no player connected
  std::vector<TranscriptError> errors;  ///< in line order; replay continues after an error
};

/// Replays lines of tab-separated "S>C or C>S, seconds, message" (# starts a comment line) through
/// a new world model. Team name and goalie come from the init or reconnect request. A decision is
/// the first command message after a sense_body. Skips messages irrelevant to the world model.
TranscriptReplay replay_transcript(std::string_view transcript, const OnDecision& on_decision);

}  // namespace cls::player
