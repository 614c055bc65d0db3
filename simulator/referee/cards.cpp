// Cards and their words.
#include "simulator/referee/cards.h"

#include "simulator/referee/calls.h"
#include "simulator/world/roster.h"

namespace cls::simulator {
void show_red_card(World& world, Player& player, Events& events) {
  announce(world, {"red_card", player.side, player.unum}, events);
  send_off(world, player.slot(), events);
}

void show_yellow_card(World& world, Player& player, Events& events) {
  announce(world, {"yellow_card", player.side, player.unum}, events);
  ++player.cards;
  player.state |= state::kYellowCard;
  if (player.cards > 1) show_red_card(world, player, events);
}

}  // namespace cls::simulator
