// Who is who at the least total cost.
#pragma once

#include <array>
#include <cstddef>

namespace cls::proxy {

/// Costs of giving `rows` tasks to `columns` takers; at least as many columns as rows.
struct CostTable {
  static constexpr std::size_t kMaxRows = 24;
  static constexpr std::size_t kMaxColumns = 72;

  std::size_t rows = 0;
  std::size_t columns = 0;
  std::array<std::array<double, kMaxColumns>, kMaxRows> cost{};
};

/// The column of each row in an assignment of least total cost, every column used at most once
/// (Hungarian method, O(rows^2 columns)). Equal costs fall to the lower column.
std::array<std::size_t, CostTable::kMaxRows> assign(const CostTable& table);

}  // namespace cls::proxy
