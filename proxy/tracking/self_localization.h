// Where the agent stands and how it is turned: own motion every cycle, landmarks every see.
#pragma once

#include "proxy/world/world_model.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"

namespace cls::proxy {

/// Takes the step that led to this sense_body into the pose, velocity and neck: own commands as
/// far as the counters confirm them, then the sensed speed and its direction. `world.self` still
/// holds the counters of the previous sense_body. `cycles` is 1 unless sense_body messages were
/// lost; what happened in the lost ones is unknown.
void advance_self(WorldModel& world, const soccer::SenseBody& sense, int cycles);

/// Corrects the pose by all landmarks and lines of the see. Without a pose, or when the landmarks
/// contradict it (the referee moved us), it starts anew from them. False when the message shows
/// too little to be localised by it.
bool localize(WorldModel& world, const soccer::See& see);

}  // namespace cls::proxy
