// TCP connections with a timeout.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "base/system/unique_fd.h"

namespace cls::base {

/// Makes a non-blocking TCP socket for an address family, such as one in another network. Called by
/// any thread.
using TcpSocketMaker = std::function<UniqueFd(int family)>;

/// A TCP socket that is not connected, non-blocking and closed on exec; none: `errno` says why.
UniqueFd make_tcp_socket(int family);

/// A connected, non-blocking socket, or none if no address of `host` accepts a connection before
/// `deadline`. `host` is a name or an IP address, with or without brackets. Empty `make`: sockets
/// of the network of this process.
UniqueFd connect_tcp(const std::string& host, int port,
                     std::chrono::steady_clock::time_point deadline,
                     const TcpSocketMaker& make = {});

/// Waits until poll() reports one of `events` for `fd`; false if `deadline` passes or a signal
/// interrupts.
bool wait_for_events(int fd, short events, std::chrono::steady_clock::time_point deadline);

}  // namespace cls::base
