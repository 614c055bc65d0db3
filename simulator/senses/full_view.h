// What a player may know exactly: the fullstate message.
#pragma once

#include "simulator/world/world.h"
#include "soccer/messages/full_state.h"

namespace cls::simulator {

/// Fills `out` with the whole world as the player in `slot` is told it when its side has
/// fullstate on.
void full_state(const World& world, Slot slot, soccer::FullState& out);

/// True if the parameters give the side of that player the full state.
bool has_full_state(const World& world, const Player& player);

}  // namespace cls::simulator
