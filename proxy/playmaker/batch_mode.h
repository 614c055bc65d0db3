// Whether a team asks with the calls of TeamPlaymaker (docs/wire.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/text/enum_names.h"

namespace cls::proxy {

enum class BatchMode : std::uint8_t {
  kAuto,      ///< when the Playmaker implements them
  kOff,       ///< always the calls of Game
  kRequired,  ///< a Playmaker without them is refused
};

inline constexpr auto kBatchModeNames = base::enum_names<BatchMode>("auto", "never", "always");

constexpr std::string_view name(BatchMode mode) { return kBatchModeNames.name(mode); }

constexpr std::optional<BatchMode> parse_batch_mode(std::string_view text) {
  return kBatchModeNames.parse(text);
}

}  // namespace cls::proxy
