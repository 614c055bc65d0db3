// Possession chains: from gaining to losing the ball.
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
  kBoxEntry,  ///< the ball entered the opponent's penalty area
  kLost,      ///< an opponent touched next, or both teams simultaneously
  kOut,       ///< ball out or play stopped
};
std::string_view name(ChainResult result);

/// A maximal sequence of touches of one team in one live phase. `result` is the best outcome.
struct Chain {
  std::size_t team = 0;
  std::uint32_t first_touch = 0;  ///< indices into Flow::touches
  std::uint32_t last_touch = 0;
  int passes = 0;            ///< completed ones
  std::uint32_t frames = 0;  ///< from the first touch to the last
  soccer::Vec2 from;  ///< contact points of the first and last touch, as the team sees the pitch
  soccer::Vec2 to;
  bool from_set_play = false;  ///< began with the touch that restarted play
  ChainResult result = ChainResult::kLost;
};

std::vector<Chain> find_chains(const Flow& flow, const std::vector<Pass>& passes,
                               const std::vector<Shot>& shots);

/// The chain in which a shot was taken; null if there is none.
const Chain* chain_of(const std::vector<Chain>& chains, const Shot& shot);

/// The passers before a goal: of the last completed pass to the scorer in the same chain, at most
/// 60 cycles before the shot, and of the pass before it. kNoPlayer if there is none.
struct Assist {
  std::int8_t passer = kNoPlayer;
  std::int8_t second = kNoPlayer;
};
Assist find_assist(const Flow& flow, const std::vector<Pass>& passes, const Shot& shot);

}  // namespace cls::analysis
