// Computes the threat grid by value iteration.
#include "analysis/measures/threat.h"

#include <algorithm>

#include "soccer/pitch.h"

namespace cls::analysis {
namespace {

constexpr int kRounds = 20;

struct Move {
  std::size_t from;
  std::size_t to;
};

std::size_t cell_index(double value, double half, std::size_t count) {
  const double share = std::clamp((value + half) / (2 * half), 0.0, 1.0);
  return std::min(count - 1, static_cast<std::size_t>(share * static_cast<double>(count)));
}

}  // namespace

std::size_t threat_cell(soccer::Vec2 seen) {
  return cell_index(seen.y, soccer::kHalfWidth, kThreatRows) * kThreatColumns +
         cell_index(seen.x, soccer::kHalfLength, kThreatColumns);
}

ThreatGrid threat_grid(const Flow& flow, const std::vector<Pass>& passes,
                       const std::vector<Carry>& carries, const std::vector<Shot>& shots,
                       const std::vector<double>& expected) {
  ThreatGrid actions = {};  // all actions that began in a cell, including lost balls
  ThreatGrid shot_worth = {};
  std::vector<Move> moves;

  for (const Pass& pass : passes) {
    ++actions[threat_cell(pass.from)];
    if (pass.completed()) moves.push_back({threat_cell(pass.from), threat_cell(pass.to)});
  }
  for (const Carry& carry : carries) {
    ++actions[threat_cell(carry.from)];
    moves.push_back({threat_cell(carry.from), threat_cell(carry.to)});
  }

  for (std::size_t i = 0; i < shots.size(); ++i) {
    const soccer::Vec2 contact = flow.touches[shots[i].touch].contact;
    const std::size_t cell = threat_cell(contact * attack_sign(shots[i].slot));
    ++actions[cell];
    shot_worth[cell] += expected[i];
  }

  ThreatGrid grid = {};
  for (int round = 0; round < kRounds; ++round) {
    ThreatGrid next = shot_worth;
    for (const Move& move : moves) next[move.from] += grid[move.to];
    for (std::size_t i = 0; i < grid.size(); ++i) {
      grid[i] = actions[i] > 0.0 ? next[i] / actions[i] : 0.0;
    }
  }
  return grid;
}

PerPlayer<double> threat_added(const ThreatGrid& grid, const std::vector<Pass>& passes,
                               const std::vector<Carry>& carries) {
  PerPlayer<double> added = {};
  const auto add = [&](std::int8_t slot, const auto& move) {
    added[slot_index(slot)] += grid[threat_cell(move.to)] - grid[threat_cell(move.from)];
  };

  for (const Pass& pass : passes) {
    if (pass.completed()) add(pass.passer, pass);
  }
  for (const Carry& carry : carries) add(carry.slot, carry);
  return added;
}

}  // namespace cls::analysis
