// The real rcssserver as a partner of conversations, where there is one.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/simulator/conversation.h"

namespace cls::tests {

/// `rcssserver` on PATH, or the program that CLS_RCSSSERVER names; empty when there is none.
std::string real_server();

/// A real server of its own with those settings, in real time at free ports, that ends with the
/// host. Throws when it does not start.
std::unique_ptr<Host> make_real_host(const std::vector<std::string>& settings);

}  // namespace cls::tests
