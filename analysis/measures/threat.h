// Expected threat (xT): change of the scoring probability by passes and carries.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "analysis/play/carries.h"
#include "analysis/play/flow.h"
#include "analysis/play/passes.h"
#include "analysis/play/shots.h"

namespace cls::analysis {

/// Grid over the pitch as a team sees it; column 0 is at its own goal line.
constexpr std::size_t kThreatColumns = 16;
constexpr std::size_t kThreatRows = 12;
using ThreatGrid = std::array<double, kThreatColumns * kThreatRows>;

std::size_t threat_cell(soccer::Vec2 seen);

/// Value of each cell: probability of a shot as the next action times its goal probability, plus
/// the probability of a move times the value of its target cells
/// (docs/spec/match-statistics.md 3.5). Estimated from both teams' actions in this match; a lost
/// ball has value 0. `expected` holds the goal probability of each shot.
ThreatGrid threat_grid(const Flow& flow, const std::vector<Pass>& passes,
                       const std::vector<Carry>& carries, const std::vector<Shot>& shots,
                       const std::vector<double>& expected);

/// Per player: sum over completed passes and carries of the value at the end minus the value at the
/// start.
PerPlayer<double> threat_added(const ThreatGrid& grid, const std::vector<Pass>& passes,
                               const std::vector<Carry>& carries);

}  // namespace cls::analysis
