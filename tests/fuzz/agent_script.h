// Agent scripts: any bytes are a valid sequence of messages of a server and a Playmaker.
#pragma once

#include <string_view>

namespace cls::tests {

/// Plays a script to an agent of the proxy; aborts if the agent sends a command that no server
/// could parse. The first character selects the agent: p player, g goalie, c online coach, t
/// trainer. Lines:
///     a ACTIONS      reply of the Playmaker from now on, in protobuf text format
///     r NUMBER       random reply of the Playmaker from now on, over all fields
///     n NUMBER       planner node that the Playmaker selects
///     l              the Playmaker does not reply from now on
///     anything else  a datagram of the server, followed by the decision that is due
/// Returns the number of decisions.
int play_agent_script(std::string_view script);

}  // namespace cls::tests
