// Drawing drivers; messages for players that perceive.
#include "training/episode/others.h"

#include <utility>

#include "base/index.h"

namespace cls::training {
namespace {

void draw_drivers(const Setup& setup, const simulator::World& world, Others& others) {
  soccer::RandomStream stream(world.seed, "training drivers");
  const int teammates = draw_driver(setup.teammates, stream);
  others.opponent = draw_driver(setup.opponents, stream);

  for (std::size_t slot = 0; slot < others.drivers.size(); ++slot) {
    const bool opponent = setup.is_opponent[slot];
    const DriverPool& pool = opponent ? setup.opponents : setup.teammates;
    const int drawn = opponent ? others.opponent : teammates;
    if (drawn < 0) continue;

    Driver& driver = others.drivers[slot];
    driver = pool[base::index(drawn)].driver;
    const bool stands = setup.task->lazy && opponent && !world.players[slot].goalie;
    if (stands && driver == Driver::kScripted) driver = Driver::kHold;
  }
}

template <typename Do>
void for_each_player(const Setup& setup, Others& others, Do&& what) {
  if (others.players.empty()) return;
  for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    if (MatchPlayer* player = match_player(setup, others, slot)) what(slot, *player);
  }
}

}  // namespace

const MatchPlayer* match_player(const Setup& setup, const Others& others, int slot) {
  const auto i = base::index(slot);
  const int index = setup.match_player_of[i];
  if (index < 0 || !perceives(others.drivers[i])) return nullptr;
  return &others.players[base::index(index)];
}

MatchPlayer* match_player(const Setup& setup, Others& others, int slot) {
  return const_cast<MatchPlayer*>(match_player(setup, std::as_const(others), slot));
}

void begin_others(const Setup& setup, const simulator::World& world,
                  const simulator::Events& events, SenseBuffers& buffers, Others& others) {
  draw_drivers(setup, world, others);
  for_each_player(setup, others, [&](int slot, MatchPlayer& player) {
    player =
        setup.match_players[base::index(setup.match_player_of[static_cast<std::size_t>(slot)])];
    begin_perception(*setup.vision, world, events, slot, player.senses, buffers);
  });
}

void queue_says(const Setup& setup, const simulator::World& world, const simulator::Events& events,
                std::size_t first, Others& others) {
  for (std::size_t i = first; i < events.size(); ++i) {
    const auto* said = std::get_if<simulator::PlayerSaid>(&events[i].what);
    if (said == nullptr) continue;
    for_each_player(setup, others, [&](int slot, MatchPlayer& player) {
      queue_say(world, *said, slot, player.senses.said);
    });
  }
}

void perceive_others(const Setup& setup, simulator::World& world, const simulator::Events& events,
                     SenseBuffers& buffers, Others& others) {
  for_each_player(setup, others, [&](int slot, MatchPlayer& player) {
    perceive(*setup.vision, world, events, slot, player.senses, buffers);
  });
}

}  // namespace cls::training
