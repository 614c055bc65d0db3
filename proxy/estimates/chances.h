// What the agent can do to the ball now: reach of kick, catch and tackle, and their chances.
#pragma once

#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Fills kickable, kick_rate, the probabilities of catch, tackle and foul, and the safe dash power
/// of `world.self` (proxy behaviour 3.4). Foul chances count as if an opponent had the ball.
void judge_chances(WorldModel& world);

/// Distance to which a goalie may still catch the ball, and the one within which it surely does.
struct CatchReach {
  double sure = 0.0;
  double farthest = 0.0;
};
CatchReach catch_reach(const WorldModel& world);

}  // namespace cls::proxy
