// Energy: what a cycle gives back.
#pragma once

#include "simulator/world/world.h"

namespace cls::simulator {

/// One cycle's change of effort, recovery, stamina and capacity (section 5).
void update_stamina(const World& world, Player& player);

/// Everything as at the start of the match, hearing included.
void recover(const World& world, Player& player);

/// `recover` for every enabled player.
void recover_all(World& world);

}  // namespace cls::simulator
