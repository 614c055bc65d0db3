// Messages that follow the reply to an init of any client (docs/spec/server-protocol.md 2.1).
#pragma once

#include "simulator/sessions/connection.h"

namespace cls::simulator {

/// First client version with synchronous view mode (docs/spec/simulation-model.md 7.1).
constexpr int kFirstSynchronousVersion = 18;
/// First client version that receives changes of the goalie.
constexpr int kFirstGoalieChangeVersion = 16;

/// True if the server supports clients of this version.
bool is_supported_version(double version);

/// Sends server_param, player_param and the player types in the form of the client's version.
void send_parameters(const World& world, Connection& client);

/// Sends the players with a type other than the default; without the type for opponents of `side`.
void send_changed_types(const World& world, Side side, Connection& client);

/// Sends the text of server::coach_msg_file to an online coach, unless it cannot be read or is too
/// long for a message.
void send_coach_file(const World& world, Connection& coach);

}  // namespace cls::simulator
