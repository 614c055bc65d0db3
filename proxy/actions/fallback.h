// Automatic play for missed decisions (OnLate::kDefault).
#pragma once

#include "player/world/world_model.h"
#include "proto/playmaker.pb.h"

namespace cls::proxy {

/// Replaces `out`: clear the ball, intercept it when first, otherwise move to the home position;
/// look at the ball.
void choose_fallback_actions(const player::WorldModel& world, protos::PlayerActions& out);

}  // namespace cls::proxy
