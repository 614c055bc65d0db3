// Replays conversations against server processes: rcssserver and cls server.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/simulator/sessions/conversation.h"

namespace cls::tests {

/// Starts a server process by `command` with the settings, in real time on free ports, and
/// terminates it with the host. Throws if it does not start.
std::unique_ptr<Host> make_process_host(const std::vector<std::string>& command,
                                        const std::vector<std::string>& settings);

}  // namespace cls::tests
