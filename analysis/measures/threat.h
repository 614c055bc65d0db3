// Expected threat: how much closer to a goal passes and carries bring the ball.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "analysis/play/carries.h"
#include "analysis/play/flow.h"
#include "analysis/play/passes.h"
#include "analysis/play/shots.h"

namespace cls::analysis {

/// A grid over the pitch as a team sees it; column 0 is its own goal line.
constexpr std::size_t kThreatColumns = 16;
constexpr std::size_t kThreatRows = 12;
using ThreatGrid = std::array<double, kThreatColumns * kThreatRows>;

std::size_t threat_cell(soccer::Vec2 seen);

/// What a cell is worth: the chance that the next thing from there is a shot times how likely shots
/// from there score, plus the chance of a move times what the cells that moves lead to are worth
/// (match-statistics 3.5), estimated from both teams' play in this match. A lost ball is worth
/// nothing. `expected` holds a probability for each shot.
ThreatGrid threat_grid(const Flow& flow, const std::vector<Pass>& passes,
                       const std::vector<Carry>& carries, const std::vector<Shot>& shots,
                       const std::vector<double>& expected);

/// Sum over each player's completed passes and carries: worth of the end minus that of the start.
PerPlayer<double> threat_added(const ThreatGrid& grid, const std::vector<Pass>& passes,
                               const std::vector<Carry>& carries);

}  // namespace cls::analysis
