// Possession chains: what a team does between winning and losing the ball.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "analysis/play/flow.h"
#include "analysis/play/passes.h"
#include "analysis/play/shots.h"

namespace cls::analysis {

enum class ChainResult : std::uint8_t {
  kGoal,
  kShot,
  kBoxEntry,  ///< the ball got into the opponent's penalty area
  kLost,      ///< an opponent touched next, or both teams at once
  kOut,       ///< ball out or play stopped
};
std::string_view name(ChainResult result);

/// A maximal run of touches of one team in one live phase. The best that came of it is its result.
struct Chain {
  std::size_t team = 0;
  std::uint32_t first_touch = 0;  ///< indices into Flow::touches
  std::uint32_t last_touch = 0;
  int passes = 0;            ///< completed ones
  std::uint32_t frames = 0;  ///< from the first touch to the last
  soccer::Vec2 from;         ///< contacts of the first and the last touch, as the team sees them
  soccer::Vec2 to;
  bool from_set_play = false;  ///< began with the touch that restarted the game
  ChainResult result = ChainResult::kLost;
};

std::vector<Chain> chains_of(const Flow& flow, const std::vector<Pass>& passes,
                             const std::vector<Shot>& shots);

/// Who gave the passes before a goal: the last completed pass to the scorer in the same chain, at
/// most 60 cycles before his shot, and the one before it. kNobody where there is none.
struct Assist {
  std::int8_t passer = kNobody;
  std::int8_t second = kNobody;
};
Assist assist_of(const Flow& flow, const std::vector<Pass>& passes, const Shot& shot);

}  // namespace cls::analysis
