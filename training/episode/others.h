// The players of an episode that are not agents: who plays them, and what they know.
#pragma once

#include <array>
#include <vector>

#include "simulator/world/event.h"
#include "training/episode/setup.h"

namespace cls::training {

/// A copyable value.
struct Others {
  std::array<Driver, soccer::kPlayersOnPitch>
      drivers{};                     ///< by slot; of players that are not agents
  std::vector<MatchPlayer> players;  ///< by Setup::match_player_of
  int opponent = -1;  ///< index of the opponents' driver in Setup::opponents; -1: none
};

/// The player in `slot` if its driver perceives; else null.
MatchPlayer* match_player(const Setup& setup, Others& others, int slot);
const MatchPlayer* match_player(const Setup& setup, const Others& others, int slot);

/// Start of an episode: draws the drivers by its seed and gives their players the first messages.
void begin_others(const Setup& setup, const simulator::World& world,
                  const simulator::Events& events, SenseBuffers& buffers, Others& others);

/// Queues what players have said since event `first` for those who may hear it.
void queue_says(const Setup& setup, const simulator::World& world, const simulator::Events& events,
                std::size_t first, Others& others);

/// Gives all players that perceive the messages of a cycle.
void perceive_others(const Setup& setup, simulator::World& world, const simulator::Events& events,
                     SenseBuffers& buffers, Others& others);

}  // namespace cls::training
