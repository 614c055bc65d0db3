// Player types: substitutions by coaches and assignment at the first kick-off.
#pragma once

#include "simulator/world/event.h"
#include "soccer/commands/coach_command.h"
#include "soccer/messages/server_reply.h"

namespace cls::simulator {

/// Handles an online coach's (change_player_type UNUM TYPE) and returns the reply
/// (docs/spec/simulation-model.md 6.2).
soccer::ServerReply change_type(World& world, Side side, int unum, int type, Events& events);

/// Handles a trainer's (change_player_type TEAM UNUM TYPE): unlimited, at any time.
soccer::ServerReply change_type(World& world, const soccer::TrainerChangePlayerType& command,
                                Events& events);

/// Handles an online coach's (change_player_type UNUM goalie).
soccer::ServerReply change_goalie(World& world, Side side, int unum, Events& events);

/// Assigns the type and full stamina without checking the rules; counts as a substitution once the
/// clock has started.
void substitute(World& world, Slot slot, int type, Events& events);

/// Assigns a distinct type to each player without one; called at the first kick-off.
void assign_types(World& world, Side side, Events& events);

}  // namespace cls::simulator
