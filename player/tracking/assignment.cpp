// Hungarian method: shortest augmenting paths with row and column potentials.
#include "player/tracking/assignment.h"

#include <cassert>
#include <limits>

namespace cls::player {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

struct Solver {
  const CostTable& table;
  std::array<double, CostTable::kMaxRows> row_potential{};
  std::array<double, CostTable::kMaxColumns> column_potential{};
  std::array<std::size_t, CostTable::kMaxColumns> row_of{};  ///< kNone: free

  /// Assigns `row`, reassigning other rows where that is cheaper.
  void insert(std::size_t row) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    std::array<double, CostTable::kMaxColumns> distance;
    std::array<std::size_t, CostTable::kMaxColumns> previous;
    std::array<bool, CostTable::kMaxColumns> done{};
    distance.fill(kFar);
    previous.fill(kNone);

    std::size_t at_row = row;
    std::size_t at_column = kNone;
    double travelled = 0.0;
    std::array<double, CostTable::kMaxColumns> settled{};

    while (true) {
      std::size_t next = kNone;
      for (std::size_t c = 0; c < table.columns; ++c) {
        if (done[c]) continue;
        const double through =
            travelled + table.cost[at_row][c] - row_potential[at_row] - column_potential[c];
        if (through < distance[c]) {
          distance[c] = through;
          previous[c] = at_column;
        }
        if (next == kNone || distance[c] < distance[next]) next = c;
      }

      assert(next != kNone);
      done[next] = true;
      travelled = settled[next] = distance[next];
      at_column = next;
      if (row_of[next] == kNone) break;
      at_row = row_of[next];
    }

    row_potential[row] += travelled;
    for (std::size_t c = 0; c < table.columns; ++c) {
      if (!done[c] || row_of[c] == kNone) continue;
      row_potential[row_of[c]] += travelled - settled[c];
      column_potential[c] -= travelled - settled[c];
    }

    while (at_column != kNone) {
      const std::size_t from = previous[at_column];
      row_of[at_column] = from == kNone ? row : row_of[from];
      at_column = from;
    }
  }
};

}  // namespace

std::array<std::size_t, CostTable::kMaxRows> assign(const CostTable& table) {
  assert(table.rows <= table.columns);
  Solver solver{table};
  solver.row_of.fill(kNone);

  for (std::size_t row = 0; row < table.rows; ++row) solver.insert(row);
  std::array<std::size_t, CostTable::kMaxRows> column_of{};

  for (std::size_t c = 0; c < table.columns; ++c) {
    if (solver.row_of[c] != kNone) column_of[solver.row_of[c]] = c;
  }

  return column_of;
}

}  // namespace cls::player
