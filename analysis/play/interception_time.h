// How soon players can reach a rolling ball: a simple bound.
#pragma once

#include <cstddef>
#include <optional>

#include "analysis/play/flow.h"

namespace cls::analysis {

/// Nobody is asked further ahead.
constexpr int kLongestInterception = 50;

/// The first player to reach the ball of a frame if nobody touches it, and after how many cycles.
struct Interception {
  std::size_t slot = 0;
  int cycles = 0;
};

/// A player stands for one cycle, turns for none (less than 15 degrees off), one or two (more than
/// 90 degrees and running), then runs at 95 % of his top speed until the ball is within his
/// kickable radius (match-statistics 3.11). Of several players at once the nearer one counts.
/// Nothing if nobody gets there in time, or both teams do at once (then nobody is first).
std::optional<Interception> first_to_ball(const gamelog::MatchRecord& record, std::size_t frame);

/// Cycles until this player reaches the ball; nothing beyond the limit.
std::optional<int> cycles_to_ball(const gamelog::MatchRecord& record, std::size_t frame,
                                  std::size_t slot);

}  // namespace cls::analysis
