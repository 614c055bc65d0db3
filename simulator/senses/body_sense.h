// sense_body: a player's own state.
#pragma once

#include "simulator/world/world.h"
#include "soccer/messages/sense_body.h"

namespace cls::simulator {

/// Builds the sense_body message of the player in `slot`. Does not clear Player::contacts; the
/// sender does.
soccer::SenseBody sense_body(const World& world, Slot slot);

/// State of the arm for sense_body and fullstate. With `rounded` (sense_body) the distance is
/// rounded to 0.1 and the direction truncated; otherwise the distance is exact and the direction
/// rounded.
soccer::ArmState arm_state(const World& world, const Player& player, bool rounded);

/// Target of the pointing arm relative to the face direction; radians.
struct ArmAim {
  double distance;
  double direction;
};
ArmAim arm_aim(const Player& player);

soccer::CommandCounts command_counts(const Counters& counters);

soccer::Card card(const Player& player);

}  // namespace cls::simulator
