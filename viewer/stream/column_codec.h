// Codes the integers of one column and remembers where its series stand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "viewer/stream/bytes.h"
#include "viewer/stream/column_table.h"

namespace cls::viewer {

/// Integers of all series of a column, series after series.
using Integers = std::vector<std::int64_t>;

/// Largest magnitude of an integer in a stream.
constexpr std::int64_t kMaxInteger = std::int64_t{1} << 32;
/// The largest integer that stands for a real number; values beyond are exceptions.
constexpr std::int64_t kMaxScaled = std::int64_t{1} << 30;

/// `values` is a table with rows of `columns` entries; returns it column after column.
template <typename T>
std::vector<T> transposed(const std::vector<T>& values, std::size_t columns) {
  const std::size_t rows = values.size() / columns;
  std::vector<T> result(values.size());
  for (std::size_t column = 0; column < columns; ++column) {
    for (std::size_t row = 0; row < rows; ++row) {
      result[column * rows + row] = values[row * columns + column];
    }
  }
  return result;
}

/// Where the series of a column stand after the frames coded so far.
struct ColumnState {
  explicit ColumnState(std::size_t series) : previous(series, 0), difference(series, 0) {}

  std::vector<std::int64_t> previous;
  std::vector<std::int64_t> difference;
};

/// Inputs of the coding of a column in addition to its own integers.
struct CodingInput {
  Coding coding = Coding::kChanges;
  std::int64_t half_turn = 0;             ///< kAngle: the integer of 180 degrees
  const Integers* predictions = nullptr;  ///< kVelocity: predicted_velocities()
};

/// Brings an angle into (-half_turn, half_turn].
std::int64_t wrapped(std::int64_t angle, std::int64_t half_turn);

/// Decays are integers of this unit: 1.
constexpr std::int64_t kDecayUnit = 10000;

/// What velocities would be if the displacement of each frame decayed. `positions` are the integers
/// of these frames, `before` those of the frame before them, by series; `decays` one per
/// integer.
Integers predicted_velocities(const Integers& positions, const std::vector<std::int64_t>& before,
                              const Integers& decays);

/// Appends `values` and advances `state`. Angles must be wrapped.
void encode_column(const CodingInput& input, const Integers& values, ColumnState& state,
                   std::string& out);

/// Reads `frames` frames and advances `state`; `in` fails at values beyond kMaxInteger.
Integers decode_column(const CodingInput& input, std::size_t frames, ColumnState& state,
                       ByteReader& in);

}  // namespace cls::viewer
