// Minimum-cost assignment.
#pragma once

#include <array>
#include <cstddef>

namespace cls::player {

/// Cost matrix; at least as many columns as rows.
struct CostTable {
  static constexpr std::size_t kMaxRows = 24;
  static constexpr std::size_t kMaxColumns = 72;

  std::size_t rows = 0;
  std::size_t columns = 0;
  std::array<std::array<double, kMaxColumns>, kMaxRows> cost;  ///< unset; rows and columns in use
};

/// Column of each row in a minimum-cost assignment; each column is used at most once (Hungarian
/// method, O(rows^2 columns)). Ties go to the lower column.
std::array<std::size_t, CostTable::kMaxRows> assign(const CostTable& table);

}  // namespace cls::player
