// The columns of recorded decisions: names, units, codings, and where a sample has them.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "viewer/decisions/decision_sample.h"
#include "viewer/stream/column_codec.h"

namespace cls::viewer {

/// Slots of players of unknown number. A player holds its slot while it is tracked.
constexpr std::size_t kUnnumberedSlots = soccer::kPlayersOnPitch;

/// A sample with slots for players of unknown number; the others were dropped.
struct SlottedSample {
  DecisionSample sample;
  std::array<UnnumberedPlayer, kUnnumberedSlots> unnumbered;  ///< id 0: free
};

/// One column of real numbers, stored as integers. `load` and `store` copy the
/// value of a series.
struct DecisionColumnSpec {
  std::string_view name;
  Coding coding;
  std::size_t series;  ///< 1, or 22: one per slot
  int scale;           ///< stored integers per unit
  double (*load)(const SlottedSample& from, std::size_t series);
  void (*store)(SlottedSample& to, std::size_t series, double value);
};

/// In the order of the format.
const std::vector<DecisionColumnSpec>& decision_columns();

}  // namespace cls::viewer
