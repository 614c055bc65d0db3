// Views without noise: fullstate for players, see_global for coaches.
#pragma once

#include "simulator/world/world.h"
#include "soccer/messages/full_state.h"
#include "soccer/messages/global_view.h"

namespace cls::simulator {

/// Fills `out` with the fullstate message of the player in `slot`.
void full_state(const World& world, Slot slot, soccer::FullState& out);

/// True if fullstate is enabled for the side of the player.
bool has_full_state(const World& world, const Player& player);

/// Fills `out` with the see_global, or the reply to look, for a client of `version` on `side`
/// (neutral: the trainer, which receives the real names of both teams). See protocol 5.2.
void coach_view(const World& world, Side side, int version, bool is_look_reply,
                soccer::GlobalView& out);

}  // namespace cls::simulator
