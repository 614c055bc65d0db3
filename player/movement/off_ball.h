// Off-ball positions: where to block a dribbler, mark an opponent, or support a teammate.
#pragma once

#include <optional>

#include "player/formation/formation.h"
#include "player/world/world_model.h"

namespace cls::player {

/// True if an opponent has the ball or gets it before our team.
bool opponents_are_first(const WorldModel& world);

/// Earliest point at which the agent blocks an opponent dribbling toward our goal. Empty if no
/// opponent has or gets the ball, a teammate blocks earlier, or it takes too long.
std::optional<Vec2> block_point(const WorldModel& world);

struct MarkRules {
  double near_goal = 0.0;  ///< opponents within this distance of our goal are marked, meters
  double max_cost = 0.0;   ///< maximum marking cost, meters
  double step = 0.0;       ///< distance of the marker from the opponent toward our goal, meters
  /// Opponents within 35 m of our goal are marked at up to this cost, if it is larger.
  double max_cost_near_goal = 0.0;
};
MarkRules marking_in_open_play(const WorldModel& world);
/// For set plays of the opponents: there is no offside at kick-ins and corner kicks, so unmarked
/// opponents behind our defense line are alone with the goalie.
constexpr MarkRules kSetPlayMarking{58.0, 20.0, 1.8, 35.0};

struct Mark {
  Vec2 point;  ///< a step from the opponent toward our goal
  const PlayerState* opponent = nullptr;
};
/// Whom the agent marks. Opponents near our goal, nearest first, are assigned to the free field
/// player with the lowest cost by position and home position (`home`, by unum - 1). Empty when our
/// team has the ball, it is far from our goal, or the agent has no opponent to mark.
std::optional<Mark> find_mark(const WorldModel& world, const TeamPoints& home,
                              const MarkRules& rules);

/// Best point near the home position (`home`, by unum - 1) to receive a pass from the teammate with
/// the ball: open pass lane, space, near their goal, not offside. Empty in our half, when our team
/// does not have the ball, and for players far from the ball or with low stamina.
std::optional<Vec2> support_point(const WorldModel& world, const TeamPoints& home);

}  // namespace cls::player
