// How binary game logs (rcg, versions 1 to 3) are laid out (log-formats 1.4 to 1.6).
#pragma once

#include <cstddef>

namespace cls::gamelog::rcg_binary {

/// What a record begins with, two bytes.
enum Kind : int {
  kNothing = 0,
  kShow = 1,
  kMessage = 2,
  kDraw = 3,
  kBlank = 4,
  kMode = 5,
  kTeams = 6,
  kType = 7,
  kServerParam = 8,
  kPlayerParam = 9,
};

// Sizes in bytes; of shows, behind the kind.
constexpr std::size_t kKindSize = 2;
constexpr std::size_t kShortShowSize = 316;  // version 2
constexpr std::size_t kLongShowSize = 1428;  // version 3
constexpr std::size_t kNameSize = 16;

}  // namespace cls::gamelog::rcg_binary
