// Showing cards.
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

/// Announced; the second one is a red card.
void show_yellow_card(World& world, Player& player, Events& events);

/// Announced; the player is sent off.
void show_red_card(World& world, Player& player, Events& events);

}  // namespace cls::simulator
