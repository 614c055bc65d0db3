// Servers that are programs as partners of conversations: the real rcssserver where there is one,
// and ours.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/simulator/conversation.h"

namespace cls::tests {

/// A server of its own that `command` starts, with those settings, in real time at free ports, and
/// that ends with the host. Throws when it does not start.
std::unique_ptr<Host> make_real_host(const std::vector<std::string>& command,
                                     const std::vector<std::string>& settings);

}  // namespace cls::tests
