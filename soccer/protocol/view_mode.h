// View width and quality, as named in commands and sensor messages.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/text/enum_names.h"

namespace cls::soccer {

enum class ViewWidth : std::uint8_t { kNarrow, kNormal, kWide };
enum class ViewQuality : std::uint8_t { kHigh, kLow };

inline constexpr auto kViewWidths = base::enum_names<ViewWidth>("narrow", "normal", "wide");
inline constexpr auto kViewQualities = base::enum_names<ViewQuality>("high", "low");

constexpr std::string_view name(ViewWidth width) { return kViewWidths.name(width); }
constexpr std::string_view name(ViewQuality quality) { return kViewQualities.name(quality); }

/// The card of a player.
enum class Card : std::uint8_t { kNone, kYellow, kRed };

}  // namespace cls::soccer
