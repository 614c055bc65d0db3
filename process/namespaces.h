// Namespaces that programs share: what they are in instead of this host.
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "base/system/socket_address.h"
#include "base/system/udp_socket.h"
#include "base/system/unique_fd.h"

namespace cls::process {

struct SocketRequest;

/// A connection to a process in another network, which opens sockets there. Used by one thread at a
/// time; may be passed on to a child (CommandPlan::passed).
class NetworkDoor {
 public:
  explicit NetworkDoor(base::UniqueFd socket) : socket_(std::move(socket)) {}

  /// A socket of that network, bound to `local`. Errors are those of the system.
  base::Result<base::UdpSocket> bind_udp(const base::SocketAddress& local) const;
  /// A TCP socket of that network, not connected, non-blocking. `family`: AF_INET or AF_INET6.
  base::Result<base::UniqueFd> make_tcp(int family) const;
  int fd() const { return socket_.get(); }

 private:
  base::Result<base::UniqueFd> ask(const SocketRequest& request) const;

  base::UniqueFd socket_;
};

/// The namespaces that the programs of one party share: of users, which makes the others possible
/// without root, and of the network, with a loopback of its own. Each program that is started in
/// them (CommandPlan::namespaces) has mounts, processes, IPC and a host name of its own, too. They
/// end with this object and the last program.
class Namespaces {
 public:
  /// Made by the guard of this process. The error says what the host does not allow.
  static base::Result<std::shared_ptr<const Namespaces>> create();

  /// Into their network.
  const NetworkDoor& door() const { return door_; }

  /// Descriptors for setns().
  int user_fd() const { return user_fd_.get(); }
  int network_fd() const { return network_fd_.get(); }

 private:
  Namespaces(base::UniqueFd user, base::UniqueFd network, base::UniqueFd door)
      : user_fd_(std::move(user)), network_fd_(std::move(network)), door_(std::move(door)) {}

  base::UniqueFd user_fd_;
  base::UniqueFd network_fd_;
  NetworkDoor door_;
};

/// Why programs cannot have namespaces here, and a remedy if one is known; empty: they can. Tried
/// once in this process, which must have a guard.
const std::string& missing_namespaces();

}  // namespace cls::process
