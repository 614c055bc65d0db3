// A player's decision as a packet for soccerwindow2's debug server (docs/formats/debug-view.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "player/world/world_model.h"

namespace protos {
class PlayerActions;
}

namespace cls::proxy {

/// soccerwindow2 reads no more of a packet, its closing NUL included.
inline constexpr std::size_t kMaxDebugPacket = 8191;

/// Replaces `out` by one packet, without its closing NUL: what the agent estimates, the say message
/// in its `sent` commands, and of `reply` (null: a missed decision) the texts and those shapes that
/// the format has. `levels` selects texts and shapes, as in DebugOptions. Shapes beyond
/// kMaxDebugPacket, those with numbers that are not finite, and the end of long texts are left out.
void format_debug_view(const player::WorldModel& world, std::string_view sent,
                       const protos::PlayerActions* reply, std::uint32_t levels, std::string& out);

}  // namespace cls::proxy
