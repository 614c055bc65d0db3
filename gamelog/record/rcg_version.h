// Versions of game logs.
#pragma once

#include <cstdint>

namespace cls::gamelog {

/// 1 to 3 are binary, 4 to 7 text (docs/spec/log-formats.md 1.1). Version 7 is that of the 2.5D
/// server, which has the height of the ball.
enum class RcgVersion : std::uint8_t { kV1 = 1, kV2, kV3, kV4, kV5, kV6, kV7, kJson };

}  // namespace cls::gamelog
