// Versions of game logs.
#pragma once

#include <cstdint>

namespace cls::gamelog {

/// 1 to 3 are binary, 4 to 6 text (docs/spec/log-formats.md 1.1).
enum class RcgVersion : std::uint8_t { kV1 = 1, kV2, kV3, kV4, kV5, kV6, kJson };

}  // namespace cls::gamelog
