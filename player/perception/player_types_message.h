// The coach's freeform message with the opponents' player types, in the format of helios coaches.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "player/world/vocabulary.h"

namespace cls::player {

/// Type ids by unum - 1; -1: unknown.
using TypeIds = std::array<int, soccer::kPlayersPerTeam>;

/// Formats "(player_types (1 0) (2 -1) ... (11 17))" for a freeform message.
std::string format_player_types(const TypeIds& types);

/// Parses the first player_types message in `text`; omitted players are -1. Empty without a message
/// or with an invalid number.
std::optional<TypeIds> parse_player_types(std::string_view text);

}  // namespace cls::player
