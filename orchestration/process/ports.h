// Ports of this machine: finding free ones, keeping them, and who has one.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/process/unique_fd.h"

namespace cls::orchestration::process {

enum class Protocol { kTcp, kUdp };

/// A process that has bound a port.
struct PortOwner {
  int pid = 0;          ///< 0: not to be found out (another user's)
  std::string program;  ///< its name as ps shows it; empty when unknown
};

/// True when nobody on this machine has bound `port` on any address.
bool port_is_free(Protocol protocol, int port);

/// The processes that have bound `port` (TCP: that listen on it). Empty when nobody has.
std::vector<PortOwner> owners_of(Protocol protocol, int port);

/// "UDP port 6000 is taken by rcssserver (process 1234)".
std::string port_taken_text(Protocol protocol, int port);

/// Ports on which `pid` or a descendant of it listens (TCP) or has bound (UDP), ascending.
std::vector<int> ports_of(Protocol protocol, int pid);

/// A free port that no other cls on this machine will choose while this object lives. Nothing is
/// bound to it, so that a child can.
class ReservedPort {
 public:
  /// Chooses `count` ports below those that the kernel gives out by itself. The error says that
  /// none was found.
  static base::Result<std::vector<ReservedPort>> choose(int count);

  int number() const { return number_; }

 private:
  ReservedPort(int number, UniqueFd mark) : number_(number), mark_(std::move(mark)) {}

  int number_ = 0;
  UniqueFd mark_;  // a socket whose name says "taken" to other cls; gone with the process
};

/// True when something accepts a connection at host:port within `limit_ms`.
bool tcp_answers(const std::string& host, int port, int limit_ms);

}  // namespace cls::orchestration::process
