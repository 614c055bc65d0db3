// The processes that make namespaces, forks of the guard.
#pragma once

#include <sys/types.h>

#include <cstdint>

#include "base/system/socket_address.h"
#include "base/system/unique_fd.h"

namespace cls::process {

/// A step that may be refused; its number is in reports to cls.
enum class NamespaceStep : std::uint8_t { kUser, kNetwork, kMounts };

/// A request to the guard, as the bytes of a packet with one descriptor, for the reply.
struct NamespaceRequest {
  bool tried = false;  ///< also try what each program in them needs
};

/// The first packet of a maker: with the descriptors of the user namespace and of the network.
struct NamespaceReply {
  std::int32_t error = 0;  ///< an errno; 0: made
  NamespaceStep step = NamespaceStep::kUser;
};

/// A request to a maker to open a socket in its network: for UDP bound to `local`, for TCP of the
/// address family of `local`, not connected, non-blocking.
struct SocketRequest {
  bool tcp = false;
  base::SocketAddress local;
};

/// An errno, and the socket if that is 0.
using SocketReply = std::int32_t;

/// Body of a maker: makes the namespaces, replies over `control`, opens sockets in their network on
/// request, and exits when `control` is closed.
[[noreturn]] void run_namespace_maker(base::UniqueFd control, const NamespaceRequest& request);

/// Moves this process, which must have one thread, into the namespaces. Its next child is the first
/// of a process namespace of its own. False with errno set on failure.
bool enter_namespaces(int user, int network);

}  // namespace cls::process
