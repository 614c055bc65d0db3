// Following the ball: its own motion, own kicks, looks that show it and looks that do not.
#pragma once

#include "proxy/world/world_model.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"

namespace cls::proxy {

/// Advances the ball by `cycles` (at least 1). `world.self` still is what it was before the step,
/// when own kicks and tackles were carried out.
void advance_ball(WorldModel& world, const soccer::SenseBody& sense, int cycles);

/// Takes a look into account, whether it shows the ball or not. The own pose is up to date.
void observe_ball(WorldModel& world, const soccer::See& see);

/// The referee put the ball there, at rest.
void place_ball(WorldModel& world, soccer::Vec2 position, double deviation);

/// Copies the tracker's belief into BallState.
void publish_ball(WorldModel& world);

}  // namespace cls::proxy
