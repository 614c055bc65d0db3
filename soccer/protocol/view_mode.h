// View width and quality, as named in commands and sensor messages.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace cls::soccer {

enum class ViewWidth : std::uint8_t { kNarrow, kNormal, kWide };
enum class ViewQuality : std::uint8_t { kHigh, kLow };

constexpr std::string_view name(ViewWidth width) {
  return width == ViewWidth::kNarrow ? "narrow" : width == ViewWidth::kNormal ? "normal" : "wide";
}
constexpr std::string_view name(ViewQuality quality) {
  return quality == ViewQuality::kHigh ? "high" : "low";
}

constexpr std::optional<ViewWidth> parse_view_width(std::string_view text) {
  if (text == "narrow") return ViewWidth::kNarrow;
  if (text == "normal") return ViewWidth::kNormal;
  if (text == "wide") return ViewWidth::kWide;
  return std::nullopt;
}
constexpr std::optional<ViewQuality> parse_view_quality(std::string_view text) {
  if (text == "high") return ViewQuality::kHigh;
  if (text == "low") return ViewQuality::kLow;
  return std::nullopt;
}

/// The card of a player.
enum class Card : std::uint8_t { kNone, kYellow, kRed };

}  // namespace cls::soccer
