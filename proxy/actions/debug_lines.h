// Formats Playmakers' debug texts and drawings as lines of a soccerwindow2 debug log.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "player/world/age.h"

namespace protos {
class Log;
}

namespace cls::proxy {

/// Limits a file of debug texts and drawings; its last line, which says so, is not counted.
inline constexpr std::size_t kMaxDebugBytes = 10 << 20;

/// Appends one line for the text or shape: `CYCLE,STOPPED LEVEL KIND ...` (docs/actions.md). False,
/// appending nothing, when no member is set.
bool append_debug_action(const protos::Log& log, player::GameTime now, std::string& out);

/// True when its LoggerLevel is one of these bits; level 0, and that of no member, always is.
bool is_logged(const protos::Log& log, std::uint32_t levels);

/// Formats a debug_client message as a text of level 0.
void append_debug_text(std::string_view text, player::GameTime now, std::string& out);

}  // namespace cls::proxy
