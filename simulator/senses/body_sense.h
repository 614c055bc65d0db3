// What a player feels of itself: the sense_body message.
#pragma once

#include "simulator/world/world.h"
#include "soccer/messages/sense_body.h"

namespace cls::simulator {

/// The sense_body of the player in `slot` as the world stands. Player::contacts are told, and
/// stay: whoever sends the message in its turn clears them.
soccer::SenseBody sense_body(const World& world, Slot slot);

/// The arm as sense_body and fullstate tell it. `rounded`: distance to 0.1 and direction
/// truncated, as in sense_body; else the exact distance and the rounded direction.
soccer::ArmState arm_state(const World& world, const Player& player, bool rounded);

/// Where a player who points does so, relative to where he looks; radians.
struct ArmAim {
  double distance;
  double direction;
};
ArmAim arm_aim(const Player& player);

soccer::CommandCounts command_counts(const Counters& counters);

soccer::Card card(const Player& player);

}  // namespace cls::simulator
