// Players that perceive and decide as the agents of a match do.
#pragma once

#include "player/planner/action_memory.h"
#include "training/npc/driver.h"
#include "training/senses/perceiver.h"

namespace cls::training {

/// A copyable value.
struct MatchPlayer {
  Perceiver senses;
  player::ActionMemory memory;
};

/// Decides from the completed world model: fills player.senses.commands with what such an agent of
/// a match sends. The driver must be one that perceives.
void decide(Driver driver, MatchPlayer& player);

}  // namespace cls::training
