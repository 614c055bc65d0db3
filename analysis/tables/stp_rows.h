// Rows of tracking tables, of matches and of predictions, as the trajectory challenge reads them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "base/io/byte_source.h"
#include "base/result.h"
#include "soccer/geometry.h"

namespace cls::analysis {

/// Players by slot, then the ball.
inline constexpr std::size_t kStpAgents = 23;
inline constexpr std::size_t kStpBall = 22;

/// "l1" to "l11", "r1" to "r11", "b".
std::string stp_agent(std::size_t agent);

/// Columns that a table must have; the others are read if they are there.
enum class StpColumns : std::uint8_t {
  kNumber,        ///< `#` alone
  kLeftAndBall,   ///< and the places of the left team and the ball
  kAllPlaces,     ///< and those of the right team
  kMotion,        ///< and all velocities
  kModeAndCycle,  ///< `#`, `cycle` and `playmode`
};

struct StpRow {
  std::int64_t number = 0;  ///< the column `#`
  int cycle = 0;
  std::string_view mode;                        ///< valid during the call
  std::array<soccer::Vec2, kStpAgents> place;   ///< NaN where the cell is empty
  std::array<soccer::Vec2, kStpAgents> motion;  ///< meters a cycle
};

/// Calls `on_row` for each row; memory does not grow with the table. The error names the line; its
/// caller adds the file.
base::Result<void> read_stp_rows(base::ByteSource& table, StpColumns columns,
                                 const std::function<void(const StpRow&)>& on_row);

}  // namespace cls::analysis
