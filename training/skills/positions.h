// Where a player without the ball should be.
#pragma once

#include "training/scene/cast.h"

namespace cls::training {

/// Attack: spread over the width, level with the ball or ahead of it.
Vec2 support_position(const PointOfView& view);

/// On the line that halves the angle from the ball to the own goal, between ball and goal.
Vec2 goal_line_position(const PointOfView& view);

/// In front of the own goal, on the line from the ball to its center.
Vec2 guard_position(const PointOfView& view);

/// Near `opponent`, between it and the own goal.
Vec2 marking_position(const PointOfView& view, Seat opponent);

/// Between the ball and the open angle of an opponent who might receive it: halves the angle at
/// the ball between the own goal's posts that no teammate covers.
Vec2 angle_reducing_position(const PointOfView& view);

/// The facts that decide who marks whom; the same for all players of a team.
struct Marking {
  Seat chaser = kNoSeat;  ///< own player nearest to the ball, who marks no opponent
  Seat holder = kNoSeat;  ///< opponent nearest to the ball, whom no player marks
  Seats threats;          ///< opponents, nearest to the own goal first
};
Marking weigh_marking(const Scene& scene, const Cast& cast);

/// Seat of the opponent that this defender marks: the k-th nearest to the goal for the k-th
/// defender who is not nearest to the ball; kNoSeat if there is none.
Seat opponent_to_mark(const PointOfView& view, const Marking& marking);
Seat opponent_to_mark(const PointOfView& view);

}  // namespace cls::training
