// The words for sides, in files, options and messages.
#pragma once

#include <optional>
#include <string_view>

#include "soccer/side.h"

namespace cls::soccer {

/// "left" or "right"; "neutral" for nobody's.
constexpr const char* side_name(Side side) {
  return side == Side::kLeft ? "left" : side == Side::kRight ? "right" : "neutral";
}

/// The side that "left" or "right" names, nothing for any other word.
constexpr std::optional<Side> side_named(std::string_view word) {
  if (word == "left") return Side::kLeft;
  if (word == "right") return Side::kRight;
  return std::nullopt;
}

}  // namespace cls::soccer
