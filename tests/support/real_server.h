// The real soccer server, where there is one.
#pragma once

#include <string>

namespace cls::tests {

/// `rcssserver` on PATH, or the program that CLS_RCSSSERVER names; empty when there is none.
std::string real_server();

}  // namespace cls::tests
