// Cards and their words.
#include "simulator/referee/cards.h"

#include <string>

#include "simulator/referee/calls.h"
#include "simulator/roster.h"

namespace cls::simulator {
namespace {

void announce_card(World& world, std::string_view card, const Player& player, Events& events) {
  announce(world, std::string(card) + '_' + letter(player.side) + '_' + std::to_string(player.unum),
           events);
}

}  // namespace

void show_red_card(World& world, Player& player, Events& events) {
  announce_card(world, "red_card", player, events);
  send_off(world, player.slot(), events);
}

void show_yellow_card(World& world, Player& player, Events& events) {
  announce_card(world, "yellow_card", player, events);
  ++player.cards;
  player.state |= state::kYellowCard;
  if (player.cards > 1) show_red_card(world, player, events);
}

}  // namespace cls::simulator
