// Frames of a game log with the printed decimals, and their relation to a text log.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gamelog/record/match_record.h"
#include "simulator/replay/text_log_index.h"

namespace cls::simulator {

/// Frame `i` with the decimals that the server printed. Records hold single precision, in which
/// objects that touch may no longer do so.
gamelog::Frame printed_frame(const gamelog::MatchRecord& game, std::size_t i);

/// True if any player has one of these state bits.
bool shows_any(const gamelog::Frame& frame, std::uint32_t state_bits);

/// True if one step leads from `before` to `after`.
bool follows(Clock after, Clock before);

/// Number of frames up to the end of the text log, which may be truncated.
std::size_t covered_frames(const gamelog::MatchRecord& game, const TextLogIndex& text);

/// True if the text log has calls for most mode changes of the game log at the same times.
bool same_match(const gamelog::MatchRecord& game, const TextLogIndex& text);

}  // namespace cls::simulator
