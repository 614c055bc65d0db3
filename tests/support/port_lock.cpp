// A lock by binding a name in the abstract namespace of local sockets.
#include "tests/support/port_lock.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstring>
#include <thread>

namespace cls::tests {

namespace {

int holders = 0;  // in this process

}  // namespace

PortLock::PortLock() {
  if (++holders > 1) return;
  socket_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  constexpr char kName[] = "\0cls-test-ports-6000";
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, kName, sizeof kName - 1);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + sizeof kName - 1);
  while (::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size) != 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

PortLock::~PortLock() {
  --holders;
  if (socket_ >= 0) ::close(socket_);
}

}  // namespace cls::tests
