// Lower bound of the cycles until players reach a rolling ball.
#pragma once

#include <cstddef>
#include <optional>

#include "analysis/play/flow.h"

namespace cls::analysis {

/// Maximum prediction in cycles.
constexpr int kMaxInterceptionCycles = 50;

/// Share of its top speed at which a player is assumed to run.
constexpr double kShareOfTopSpeed = 0.95;

/// The first player to reach the ball if it is not touched before.
struct Interception {
  std::size_t slot = 0;
  int cycles = 0;
};

/// A player stands for one cycle and turns for none (less than 15 degrees off), one or two (more
/// than 90 degrees off and running). Then it runs at 95 % of its top speed until the ball is
/// kickable (docs/spec/match-statistics.md 3.11). Of several players in the same cycle the nearest
/// one counts. Nothing if no player reaches the ball in time, or both teams do in the same cycle.
std::optional<Interception> first_to_ball(const gamelog::MatchRecord& record, std::size_t frame);

/// Cycles until this player reaches the ball; nothing beyond the limit.
std::optional<int> cycles_to_ball(const gamelog::MatchRecord& record, std::size_t frame,
                                  std::size_t slot);

}  // namespace cls::analysis
