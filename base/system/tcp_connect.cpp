// Non-blocking connect to each address of a host.
#include "base/system/tcp_connect.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>

#include "base/system/socket_address.h"

namespace cls::base {
namespace {

using Time = std::chrono::steady_clock::time_point;

bool connect_to(int fd, const SocketAddress& address, Time deadline) {
  if (::connect(fd, address.get(), address.size) == 0) return true;
  if (errno != EINPROGRESS || !wait_for_events(fd, POLLOUT, deadline)) return false;

  int error = 0;
  socklen_t size = sizeof error;
  return ::getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &size) == 0 && error == 0;
}

}  // namespace

UniqueFd make_tcp_socket(int family) {
  return UniqueFd(::socket(family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

UniqueFd connect_tcp(const std::string& host, int port, Time deadline, const TcpSocketMaker& make) {
  const auto addresses = resolve_all(strip_brackets(host), port, AF_UNSPEC, SOCK_STREAM);
  if (!addresses) return UniqueFd();
  for (const SocketAddress& address : *addresses) {
    UniqueFd fd = make ? make(address.family()) : make_tcp_socket(address.family());
    if (fd && connect_to(fd.get(), address, deadline)) return fd;
  }
  return UniqueFd();
}

bool wait_for_events(int fd, short events, Time deadline) {
  const auto left =
      std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
  pollfd polled{fd, events, 0};
  return ::poll(&polled, 1, std::max(0, static_cast<int>(left.count()))) > 0;
}

}  // namespace cls::base
