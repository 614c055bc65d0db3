// Skills on a scene: one command each, chosen by geometry. Used by the action set "hfo" and by
// scripted players. Distances in meters, angles in radians in the scene's coordinates.
#pragma once

#include <array>

#include "soccer/commands/player_command.h"
#include "training/scene/scene.h"

namespace cls::training {

using soccer::PlayerCommand;

/// A command without effect on ball and body: turns by 0 degrees.
PlayerCommand stand();

/// Turns towards a point, or the ball.
PlayerCommand face(const Scene& scene, Seat self, Vec2 point);

/// Turns and dashes until `point` is within `radius`; then stands.
PlayerCommand go_to(const Scene& scene, Seat self, Vec2 point, double radius);

/// Where the ball rolls in the next cycles, if no player touches it.
struct BallPath {
  static constexpr int kCycles = 39;
  std::array<Vec2, kCycles> points;  ///< after 1, 2, ... cycles
};
BallPath ball_path(const Scene& scene);

/// When and where a player can reach the rolling ball.
struct Meeting {
  int cycles = 0;
  Vec2 point{};
};
Meeting meeting(const Scene& scene, const BallPath& path, Seat player);

/// Goes to a meeting.
PlayerCommand meet(const Scene& scene, Seat self, const Meeting& meeting);

/// Goes to where the player meets the ball.
PlayerCommand intercept(const Scene& scene, Seat self);

/// One kick that gives the ball a velocity towards `point`, at most `speed` (meters per cycle), as
/// fast and as straight as the kick rate allows. The caller has checked can_kick().
PlayerCommand kick_to(const Scene& scene, Seat self, Vec2 point, double speed);

/// Keeps the ball close on the way to `point`: kicks it a few meters ahead, or goes after it.
PlayerCommand dribble_to(const Scene& scene, Seat self, Vec2 point);

/// Point between the posts of the opponents' goal with the widest gap to opponents.
struct Shot {
  Vec2 target;
  double gap;  ///< radians to the nearest opponent in the way, at most pi
};
Shot best_shot(const Scene& scene, Seat self);

/// Kicks with full power at best_shot().
PlayerCommand shoot(const Scene& scene, Seat self);

/// Kicks the ball so that it is slow enough to be stopped when it arrives at `point`.
PlayerCommand pass_to(const Scene& scene, Seat self, Vec2 point);

/// Angle (radians) between the line to `point` and the nearest opponent that is nearer than it; pi
/// if there is none.
double lane_gap(const Scene& scene, Vec2 from, Vec2 point);

/// Chance that a tackle reaches the ball, 0..1.
double tackle_chance(const Scene& scene, Seat self);

/// True if the goalie may catch and the ball is in reach.
bool can_catch(const Scene& scene, Seat self);

/// Catches in the direction of the ball.
PlayerCommand catch_ball(const Scene& scene, Seat self);

/// Degrees from the body to the direction of `v`.
double bearing_degrees(const ScenePlayer& player, Vec2 v);

}  // namespace cls::training
