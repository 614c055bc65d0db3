// Ports of this host: finding and reserving free ports, finding the owner of a port.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "base/system/unique_fd.h"
#include "process/socket_table.h"

namespace cls::process {

/// A process that has bound a port.
struct PortOwner {
  int pid = 0;          ///< 0: unknown (process of another user)
  std::string program;  ///< its name as ps shows it; empty when unknown
};

/// The name of this host for a connection to a program on it: localhost, which has addresses of
/// both families, or 127.0.0.1 where the system does not know that name (no /etc/hosts).
const std::string& loopback_host();

/// Why programs of a match cannot talk to each other on this host: "the loopback interface is down;
/// ..."; empty: they can. `ipv4`: they need 127.0.0.1.
std::string loopback_problem(bool ipv4);

/// True when no process on this host has bound `port` on any address.
bool port_is_free(Protocol protocol, int port);

/// The processes that have bound `port` (TCP: listen on it).
std::vector<PortOwner> owners_of(Protocol protocol, int port);

/// "UDP port 6000 is taken by rcssserver (process 1234)".
std::string port_taken_text(Protocol protocol, int port);

/// That text for the first of `ports` that is taken; empty: none is. Port 0 stands for a free one.
std::string taken_port(Protocol protocol, const std::vector<int>& ports);

/// Why a program cannot listen for TCP connections at `host`, whatever the port: the name cannot be
/// resolved, or the address is of another host. Empty if it can.
std::string unusable_host(const std::string& host);

/// Ports on which `pid` or a descendant of it listens (TCP) or has bound (UDP), ascending.
std::vector<int> ports_of(Protocol protocol, int pid);

/// A free port that no other cls on this host chooses while this object exists. It stays unbound,
/// so that a child can bind it.
class ReservedPort {
 public:
  /// Chooses `count` ports below the kernel's ephemeral range. An error if there are not enough.
  static base::Result<std::vector<ReservedPort>> choose(int count);

  /// Chooses `count` consecutive ports: those from `first` on if all are free, otherwise as
  /// choose(). 0: no such wish.
  static base::Result<std::vector<ReservedPort>> choose_row(int count, int first = 0);

  int number() const { return number_; }

 private:
  ReservedPort(int number, base::UniqueFd mark) : number_(number), mark_(std::move(mark)) {}

  int number_ = 0;
  // Abstract socket that reserves the port; disappears with the process. None where other users
  // hold all names.
  base::UniqueFd mark_;
};

/// True when a server accepts a TCP connection at host:port within `limit_ms`.
bool tcp_answers(const std::string& host, int port, int limit_ms);

}  // namespace cls::process
