// Replaying what a player received and sent: from a recorded conversation to world models.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Called when the player decided, with everything he had been told by then; the world model is
/// complete().
using OnDecision = std::function<void(const WorldModel& world)>;

/// A line that is none, or a message that cannot be read.
struct TranscriptDamage {
  std::size_t line = 0;  ///< from 1
  std::string what;
};

struct TranscriptReplay {
  WorldModel world;                      ///< at the end; its unum is 0 if no player joined
  std::vector<TranscriptDamage> damage;  ///< in order; what stands behind it was replayed
};

/// Replays a transcript of lines "S>C or C>S, seconds, message" separated by tabs (lines that begin
/// with # are comments) through a fresh world model. Team name and goalie come from the player's
/// init or reconnect request. A decision is the first thing the player sent after a sense_body.
/// Messages that do not concern a world model are skipped.
TranscriptReplay replay_transcript(std::string_view transcript, const OnDecision& on_decision);

}  // namespace cls::proxy
