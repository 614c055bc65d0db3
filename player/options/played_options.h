// What somebody else chose with the ball, as the option that leads to the same.
#pragma once

#include "player/options/options.h"
#include "player/planner/plan.h"

namespace cls::player {

// `table` is that of the decision, with the ball. -1: none of the legal options is like it.

/// The first action on the path to `node`. A plan without nodes was not asked for: the ball was
/// kicked out of danger.
int option_of_plan(const WorldModel& world, const OptionTable& table, const Plan& plan, int node);

/// A kick towards `target`: the dribble or pass whose candidate ends nearest to it, at most 3 m
/// away; else the pass that ends nearest to it of those to the teammate who is nearest to it, at
/// most 5 m away. Behind their goal line between the posts it is a shot, or a clearance where the
/// agent cannot shoot.
int option_of_kick(const WorldModel& world, const OptionTable& table, Vec2 target);

/// A dribble towards `target`: the legal dribble whose direction is nearest, at most 45 degrees
/// away.
int option_of_dribble(const WorldModel& world, const OptionTable& table, Vec2 target);

}  // namespace cls::player
