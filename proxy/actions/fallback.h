// What a player does by itself when its Playmaker does not answer and standing still is not wanted.
#pragma once

#include "proto/playmaker.pb.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Replaces `out` with plain soccer: clear the ball, go for it when nearest, else keep the place in
/// the formation; and look at the ball.
void make_fallback(const WorldModel& world, protos::PlayerActions& out);

}  // namespace cls::proxy
