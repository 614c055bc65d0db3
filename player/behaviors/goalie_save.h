// A goalie across the way of the ball: its place, how it moves without losing its body direction,
// and how it saves shots (planner parameter `goalie_across`).
#pragma once

#include "player/planner/action_context.h"

namespace cls::player {

constexpr int kMaxShotCycles = 40;  ///< balls that take longer are no danger

/// A rolling ball that crosses our goal line between the posts.
struct Shot {
  double y = 0.0;
  int cycles = 0;
};

/// Where the goalie stands against a shot from `ball`: in the middle of the goal as seen from
/// there, a little in front of the line.
Vec2 place_across(const WorldModel& world, Vec2 ball);

/// Moves to the place with dashes in any direction, or turns the body so that a dash forward goes
/// to the far post and one backward to the near post.
bool slide(ActionContext& c, Vec2 place, Vec2 ball);

/// The turn or dash that brings the goalie nearest to the ball in time, or a tackle if the ball
/// leaves its reach. False if nothing brings it nearer.
bool save_shot(ActionContext& c, const Shot& shot);

}  // namespace cls::player
