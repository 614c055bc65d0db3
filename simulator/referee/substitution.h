// Player types: what coaches may change and what is given at the first kick-off.
#pragma once

#include <optional>

#include "simulator/world/event.h"
#include "soccer/commands/coach_command.h"
#include "soccer/messages/server_reply.h"

namespace cls::simulator {

/// An online coach's (change_player_type UNUM TYPE): what it must be answered (6.2).
soccer::ServerReply change_type(World& world, Side side, int unum, int type, Events& events);

/// A trainer's (change_player_type TEAM UNUM TYPE): any number of them, at any time.
soccer::ServerReply change_type(World& world, const soccer::TrainerChangePlayerType& command,
                                Events& events);

/// An online coach's (change_player_type UNUM goalie).
soccer::ServerReply change_goalie(World& world, Side side, int unum, Events& events);

/// Gives the player that type, fresh, without asking whether the rules allow it; counted once time
/// runs.
void substitute(World& world, Slot slot, int type, Events& events);

/// Gives every player that has none yet a type of its own; done at the first kick-off.
void assign_types(World& world, Side side, Events& events);

}  // namespace cls::simulator
