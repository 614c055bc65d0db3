// What a coach tells its players of the opponents' types, as helios coaches write it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "soccer/side.h"

namespace cls::proxy {

/// Type ids by unum - 1; -1: not known.
using TypeIds = std::array<int, soccer::kPlayersPerTeam>;

/// "(player_types (1 0) (2 -1) ... (11 17))", fit for a freeform message.
std::string player_types_text(const TypeIds& types);

/// The types in a text that holds such a message somewhere; players that it leaves out are not
/// known. Nothing when there is none, or a number that no player has.
std::optional<TypeIds> read_player_types(std::string_view text);

}  // namespace cls::proxy
