// Decisions with the ball in a recorded match, and what became of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/statistics/match_statistics.h"
#include "base/text/enum_names.h"
#include "soccer/side.h"

namespace cls::review {

/// What a player did with the ball.
enum class DecisionKind : std::uint8_t { kPass, kDribble, kShot, kClearance, kOther };
inline constexpr auto kDecisionNames =
    base::enum_names<DecisionKind>("pass", "dribble", "shot", "clearance", "other");

/// The kicks of a player, one or more in consecutive cycles, by which the ball left him.
struct Decision {
  std::size_t frame = 0;  ///< the state that the player decided in: the last one before the kicks
  std::size_t end = 0;    ///< the first frame after the kicks
  int cycle = 0;          ///< of the first kick
  int slot = 0;
  DecisionKind kind = DecisionKind::kOther;
  int receiver = soccer::kNoPlayer;  ///< who got a pass: slot, of either side, or kNoPlayer
  /// Goals that the state was worth to the player's team, and what it was worth kDecisionHorizon
  /// cycles later: a goal in between counts 1 or -1.
  double before = 0.0;
  double after = 0.0;

  double lost() const { return before - after; }
};

/// The cycles after a decision in which its consequences are looked for.
inline constexpr int kDecisionHorizon = 50;

/// What a frame is worth to a side at the first of: kDecisionHorizon cycles later, the frame
/// `last`, a goal (1 or -1).
double value_after(const analysis::Flow& flow, std::size_t frame, std::size_t last,
                   soccer::Side side);

/// The decisions of a side in live play, in the order of the match.
std::vector<Decision> find_decisions(const analysis::MatchStatistics& match, soccer::Side side);

/// Those that lost most, at most `count`, with `kDecisionHorizon` cycles between any two: the
/// moments that mattered. Most lost first.
std::vector<Decision> costliest(std::vector<Decision> decisions, std::size_t count);

/// "pass to 9", "pass to their 4", "dribble", "shot", ...
std::string text_of(const Decision& decision);

}  // namespace cls::review
