// A script of what a server and a Playmaker say to an agent, so that any bytes are a conversation.
#pragma once

#include <string_view>

namespace cls::tests {

/// Plays it to a player, coach or trainer of the proxy, and aborts where the agent says something
/// that no server could read. The first character of the script says who it is: p a player, g a
/// goalie, c an online coach, t a trainer. Then lines:
///     a ACTIONS      the Playmaker's answer from now on, in protobuf's text format
///     n NUMBER       the node that it chooses when asked
///     l              it does not answer from now on
///     anything else  a datagram of the server; a decision that is due by it is made
/// Returns how many decisions were made.
int play_agent_script(std::string_view script);

}  // namespace cls::tests
