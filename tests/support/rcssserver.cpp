// Finds rcssserver and free ports.
#include "tests/support/rcssserver.h"

#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "base/system/udp_socket.h"

namespace cls::tests {

std::string rcssserver_program() {
  if (const char* named = std::getenv("CLS_RCSSSERVER")) return named;
  std::istringstream path(std::getenv("PATH") == nullptr ? "" : std::getenv("PATH"));
  for (std::string folder; std::getline(path, folder, ':');) {
    const std::string program = folder + "/rcssserver";
    if (::access(program.c_str(), X_OK) == 0) return program;
  }
  return "";
}

int free_udp_port() {
  const auto socket = base::UdpSocket::bind(*base::parse_ip_address("0.0.0.0", 0));
  if (!socket) throw std::runtime_error("no free UDP port");
  return socket->local_port();
}

}  // namespace cls::tests
