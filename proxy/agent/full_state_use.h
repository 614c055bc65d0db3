// Use of the (fullstate ...) messages that a server may send to players.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/text/enum_names.h"

namespace cls::proxy {

enum class FullStateUse : std::uint8_t {
  kIgnore,
  kReference,  ///< State::full_world_model has it; agents decide by their senses
  kOverride,   ///< the world of a decision is the exact one
};

inline constexpr auto kFullStateUseNames =
    base::enum_names<FullStateUse>("ignore", "reference", "override");

constexpr std::string_view name(FullStateUse use) { return kFullStateUseNames.name(use); }

constexpr std::optional<FullStateUse> parse_full_state_use(std::string_view text) {
  return kFullStateUseNames.parse(text);
}

}  // namespace cls::proxy
