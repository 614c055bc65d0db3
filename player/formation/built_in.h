// Built-in formations: the text of their files.
#pragma once

#include <string_view>

namespace cls::player {

/// Text of player/formation/built_in/<name>.formation, embedded by the build; empty for an unknown
/// name.
std::string_view built_in_formation(std::string_view name);

}  // namespace cls::player
