// What a player could have done with the ball instead.
#pragma once

#include <string>
#include <vector>

#include "player/planner/plan.h"
#include "soccer/geometry.h"
#include "training/npc/driver.h"

namespace cls::review {

enum class AlternativeKind : unsigned char { kPlanned, kHold, kClear, kShoot };

/// A decision that the player can carry out by its own estimates. Copyable.
struct Alternative {
  AlternativeKind kind = AlternativeKind::kHold;
  player::Plan plan;      ///< of kPlanned: the root and the action
  std::string group;      ///< "pass", "through pass", "dribble", "hold", ...: for sums
  std::string text;       ///< the group with its aim: "pass to 9"
  soccer::Vec2 target{};  ///< of the ball, as the player's team sees the pitch: it attacks +x
  bool planned = false;   ///< the one that the bundled planner prefers
};

/// The planner's best action towards each teammate, its best dribble, hold, clear and, near the
/// goal, a shot: at most `most`, the best of the planner first. The player has the ball.
std::vector<Alternative> alternatives_of(const training::MatchPlayer& player, std::size_t most);

/// Cycles in which an alternative is carried out, while the player has the ball.
int longest_cycles(const Alternative& alternative);

/// One cycle of it.
void carry_out(const Alternative& alternative, training::MatchPlayer& player);

}  // namespace cls::review
