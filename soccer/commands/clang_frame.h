// The outer form of coach language (CLang) messages; their contents are not interpreted.
#pragma once

#include <optional>
#include <string_view>

#include "soccer/commands/coach_command.h"

namespace cls::soccer {

/// Parses the text after "(say" in a datagram of an online coach: one coach language message and
/// the closing parenthesis. Freeform messages must be one quoted string of say characters; the
/// other kinds must have balanced parentheses.
std::optional<CoachSay> parse_clang_say(std::string_view text);

}  // namespace cls::soccer
