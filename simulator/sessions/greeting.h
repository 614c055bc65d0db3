// What follows the reply to an init, the same for every kind of client (protocol 2.1).
#pragma once

#include "simulator/sessions/connection.h"

namespace cls::simulator {

/// server_param, player_param and the player types, in the form of the client's version.
void send_parameters(const World& world, Connection& client);

/// The players whose type is not the default one; of the other side than `side` without the type.
void send_changed_types(const World& world, Side side, Connection& client);

/// The text of server::coach_msg_file to an online coach; nothing where it cannot be read or is too
/// long for a message.
void send_coach_file(const World& world, Connection& coach);

}  // namespace cls::simulator
