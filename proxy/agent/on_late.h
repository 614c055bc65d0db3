// Behavior of a player in a cycle with a missed decision.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/text/enum_names.h"

namespace cls::proxy {

enum class OnLate : std::uint8_t {
  kHold,     ///< stands still and looks at the ball
  kLast,     ///< repeats the actions of the last reply
  kDefault,  ///< automatic play: see choose_fallback_actions()
};

inline constexpr auto kOnLateNames = base::enum_names<OnLate>("hold", "last", "default");

constexpr std::string_view name(OnLate on_late) { return kOnLateNames.name(on_late); }

constexpr std::optional<OnLate> parse_on_late(std::string_view text) {
  return kOnLateNames.parse(text);
}

}  // namespace cls::proxy
