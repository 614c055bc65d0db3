// A script of what clients send to a server, so that any bytes are a conversation.
#pragma once

#include <string_view>

namespace cls::tests {

/// Plays it to a server with memory for a network, and aborts where the server says something that
/// no client could read. Lines:
///     c REQUEST      a client asks at the players' and monitors' door; o: at the online coaches',
///     t:
///                    at the trainer's
///     5 DATAGRAM     client 5 of those that are in (counted round) sends this; with a ! before
///                    the number without the closing NUL
///     x5             its connection is lost
///     =5 DATAGRAM    it sends this to the door again
///     anything else  a cycle
void play_session_script(std::string_view script);

}  // namespace cls::tests
