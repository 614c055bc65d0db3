// Stamina model: recovery per cycle and full recovery.
#pragma once

#include "simulator/world/world.h"

namespace cls::simulator {

/// Updates effort, recovery, stamina and capacity for one cycle (docs/spec/simulation-model.md 5).
void update_stamina(const World& world, Player& player);

/// Restores stamina and hearing capacity to their values at the start of the match.
void recover(const World& world, Player& player);

/// Calls recover() for every enabled player.
void recover_all(World& world);

}  // namespace cls::simulator
