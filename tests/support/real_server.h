// Where the real rcssserver is, and ports for it.
#pragma once

#include <string>

namespace cls::tests {

/// `rcssserver` on PATH, or the program that CLS_RCSSSERVER names; empty when there is none.
std::string real_server();

/// A UDP port as good as free: nobody had it a moment ago.
int free_udp_port();

}  // namespace cls::tests
