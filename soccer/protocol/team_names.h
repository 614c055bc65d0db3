// Names that teams of `cls` may have, and those that they get from what a user wrote.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "soccer/per_side.h"

namespace cls::soccer {

using TeamNames = PerSide<std::string>;

/// `name` if it is a valid team name (letters, digits, -, + and _; at most TeamName::kMaxSize
/// characters), otherwise an error.
base::Result<std::string> check_team_name(std::string_view name);

/// A valid name from any text: its end, with whole words where enough of it is left, and with _ for
/// other characters. "team" for an empty text.
std::string team_name_from(std::string_view text);

/// Both team names, made distinct: equal names get _l and _r (shortened where needed).
TeamNames distinct_names(std::string left, std::string right);

}  // namespace cls::soccer
