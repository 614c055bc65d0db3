// Ball tracking: prediction by motion and own kicks, update by see messages.
#pragma once

#include "player/world/world_model.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"

namespace cls::player {

/// Predicts the ball `cycles` (at least 1) ahead. `world.self` is still the state before the step
/// in which own kicks and tackles were executed.
void advance_ball(WorldModel& world, const soccer::SenseBody& sense, int cycles);

/// Updates the ball by a see message that shows it or not. The own pose must be current.
void observe_ball(WorldModel& world, const soccer::See& see);

/// Sets the ball to a position at rest, as placed by the referee.
void place_ball(WorldModel& world, soccer::Vec2 position, double deviation);

/// Copies the tracker's estimate into BallState.
void publish_ball(WorldModel& world);

}  // namespace cls::player
