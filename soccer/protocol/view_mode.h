// How a player looks: view width and quality, as commands and senses name them.
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

constexpr std::optional<ViewWidth> view_width_from_name(std::string_view text) {
  if (text == "narrow") return ViewWidth::kNarrow;
  if (text == "normal") return ViewWidth::kNormal;
  if (text == "wide") return ViewWidth::kWide;
  return std::nullopt;
}
constexpr std::optional<ViewQuality> view_quality_from_name(std::string_view text) {
  if (text == "high") return ViewQuality::kHigh;
  if (text == "low") return ViewQuality::kLow;
  return std::nullopt;
}

/// A player's card as senses report it.
enum class Card : std::uint8_t { kNone, kYellow, kRed };

}  // namespace cls::soccer
