// Path of rcssserver, and ports for it.
#pragma once

#include <string>

namespace cls::tests {

/// `rcssserver` on PATH, or the program in CLS_RCSSSERVER; empty if not installed.
std::string rcssserver_program();

/// A UDP port that was free when tested.
int free_udp_port();

}  // namespace cls::tests
