// What coaches and trainers see: the whole pitch without noise (protocol 5.2).
#pragma once

#include "simulator/world/world.h"
#include "soccer/messages/global_view.h"

namespace cls::simulator {

/// Fills `out` with the see_global, or the reply to look, of a client of `version` on `side`
/// (neutral: the trainer, who sees the real names of both teams).
void coach_view(const World& world, Side side, int version, bool is_look_reply,
                soccer::GlobalView& out);

}  // namespace cls::simulator
