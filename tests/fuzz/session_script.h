// Session scripts: any bytes are a valid sequence of client actions.
#pragma once

#include <string_view>

namespace cls::tests {

/// Plays a script on a match server with clients in memory; aborts if the server sends a message
/// that no client could parse. Lines:
///     c REQUEST      a client sends a request to the port of players and monitors (o: online
///     coaches,
///                    t: trainers)
///     5 DATAGRAM     client 5, modulo the number of clients, sends a datagram
///     !5 DATAGRAM    same without the closing NUL
///     =5 DATAGRAM    same to the listening port
///     x5             client 5 loses its connection
///     anything else  one cycle
void play_session_script(std::string_view script);

}  // namespace cls::tests
