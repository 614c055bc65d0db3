// Effects of player commands on the world.
#pragma once

#include <optional>

#include "simulator/world/event.h"
#include "soccer/commands/player_command.h"
#include "soccer/messages/server_reply.h"

namespace cls::simulator {

/// Executes a command of the player in `slot` immediately and returns the reply to its client, if
/// any. Ignores disabled players. Done, Bye, Clang, Compression and RequestSenseBody have no effect
/// here; the session handles them.
std::optional<soccer::ServerReply> apply(World& world, Slot slot,
                                         const soccer::PlayerCommand& command, Events& events);

/// The part of a dash that takes effect in the step (docs/spec/simulation-model.md 4.3): converts
/// the commands of the legs into acceleration, rotation and stamina cost.
void apply_dash(World& world, Player& player);

/// True while the player's arm points, and if it may be moved.
bool is_pointing(const World& world, const Player& player);
bool can_point(const World& world, const Player& player);

}  // namespace cls::simulator
