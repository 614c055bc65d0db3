// Playmakers' debug texts and drawings, as lines of a log that soccerwindow2 shows.
#pragma once

#include <string>
#include <string_view>

#include "proxy/world/age.h"

namespace protos {
class Log;
}

namespace cls::proxy {

/// Appends one line for the text or shape: `CYCLE,STOPPED LEVEL KIND ...` (docs/actions.md). False,
/// appending nothing, when no member is set.
bool append_debug(const protos::Log& log, GameTime now, std::string& out);

/// A text of the debug client, as a text of no level.
void append_debug_text(std::string_view text, GameTime now, std::string& out);

}  // namespace cls::proxy
