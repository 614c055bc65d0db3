// Replaying what a player received and sent: from a recorded conversation to world models.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "proxy/world_model.h"
#include "soccer/result.h"

namespace cls::proxy {

/// Called when the player decided, with everything he had been told by then; the world model is
/// complete().
using OnDecision = std::function<void(const WorldModel& world)>;

/// Replays a transcript of lines "S>C or C>S, seconds, message" separated by tabs (lines that begin
/// with # are comments) through a fresh world model. Team name and goalie come from the player's
/// init request. A decision is the first thing the player sent after a sense_body. Messages that do
/// not concern a world model are skipped; a malformed one is an error that names line and byte.
soccer::Result<WorldModel> replay_transcript(std::string_view transcript,
                                             const OnDecision& on_decision);

}  // namespace cls::proxy
