// Looking for rcssserver.
#include "tests/support/real_server.h"

#include <unistd.h>

#include <cstdlib>
#include <sstream>

namespace cls::tests {

std::string real_server() {
  if (const char* named = std::getenv("CLS_RCSSSERVER")) return named;
  std::istringstream path(std::getenv("PATH") == nullptr ? "" : std::getenv("PATH"));
  for (std::string folder; std::getline(path, folder, ':');) {
    const std::string program = folder + "/rcssserver";
    if (::access(program.c_str(), X_OK) == 0) return program;
  }
  return "";
}

}  // namespace cls::tests
