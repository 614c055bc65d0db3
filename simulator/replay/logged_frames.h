// Frames of a game log as the server printed them, and which of them a text log explains.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gamelog/record/match_record.h"
#include "simulator/replay/text_log_index.h"

namespace cls::simulator {

/// Frame `i` with the decimals that were printed: a record holds them in single precision, in which
/// what touches may no longer do so.
gamelog::Frame printed_frame(const gamelog::MatchRecord& game, std::size_t i);

/// True if one of these bits is shown of any player.
bool shows_any(const gamelog::Frame& frame, std::uint32_t state_bits);

/// True if one step leads from `before` to `after`.
bool follows(Clock after, Clock before);

/// How many frames there are up to the end of the text log, which may be cut off.
std::size_t covered_frames(const gamelog::MatchRecord& game, const TextLogIndex& text);

/// True if most changes of mode in the game log are called at that very time in the text log.
bool same_match(const gamelog::MatchRecord& game, const TextLogIndex& text);

}  // namespace cls::simulator
