// What a player's command does to the world, at once.
#pragma once

#include <optional>

#include "simulator/world/event.h"
#include "soccer/commands/player_command.h"
#include "soccer/messages/server_reply.h"

namespace cls::simulator {

/// Executes a command of the player in `slot`, who must be enabled (a disabled one is ignored), and
/// returns what its client must be answered, if anything. Done, Bye, Clang, Compression and
/// AskSenseBody are the session's business and have no effect here.
std::optional<soccer::ServerReply> apply(World& world, Slot slot,
                                         const soccer::PlayerCommand& command, Events& events);

/// True if `slot`'s arm points somewhere, and if it may be moved.
bool is_pointing(const World& world, const Player& player);
bool can_point(const World& world, const Player& player);

}  // namespace cls::simulator
