// Looking for a program and for ports.
#include "tests/support/real_server.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>

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

int free_udp_port() {
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  socklen_t size = sizeof address;
  const bool named = ::bind(socket, reinterpret_cast<const sockaddr*>(&address), size) == 0 &&
                     ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  ::close(socket);
  if (!named) throw std::runtime_error("no free UDP port");
  return ntohs(address.sin_port);
}

}  // namespace cls::tests
