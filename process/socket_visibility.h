// Whether this system shows which processes hold which sockets.
#pragma once

#include <string>

namespace cls::process {

/// That owners of sockets cannot be known, where /proc does not show this process its own ones,
/// such as in a container without /proc; empty: they can.
std::string missing_socket_owners();

}  // namespace cls::process
