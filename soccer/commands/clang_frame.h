// The outer frame of coach language messages; what is inside is not interpreted.
#pragma once

#include <optional>
#include <string_view>

#include "soccer/commands/coach_command.h"

namespace cls::soccer {

/// Reads what follows "(say" in an online coach's datagram: one coach language message, the
/// closing bracket of the say, and nothing else but blanks. A freeform text must be one quoted
/// string of say characters; the other kinds must have balanced brackets.
std::optional<CoachSay> read_clang_say(std::string_view text);

}  // namespace cls::soccer
