// Self localization: dead reckoning by sense_body, correction by the landmarks of see.
#pragma once

#include "player/world/world_model.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"

namespace cls::player {

/// Dead reckoning: updates pose, velocity and neck for the step before this sense_body, from the
/// own commands confirmed by the counters, and the sensed speed and its direction. `world.self`
/// must still hold the previous counters. `cycles` is 1 unless sense_body messages were lost;
/// motion in lost cycles is unknown.
void advance_self(WorldModel& world, const soccer::SenseBody& sense, int cycles);

/// Corrects the pose by all landmarks and lines of a see message. Reinitializes it without a pose,
/// or when the landmarks contradict it (the referee moved the agent). False when the message has
/// too few landmarks.
bool localize(WorldModel& world, const soccer::See& see);

}  // namespace cls::player
