// Sockets of cls in place of those with which a program connects.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "base/result.h"
#include "base/system/socket_address.h"
#include "base/system/udp_socket.h"
#include "base/system/unique_fd.h"
#include "process/command_plan.h"

namespace cls::process {

/// Where the program of a plan, or one below it, connects to an address, it gets a socket of cls
/// under the number of its own, and does not notice it. That can be one in another network. Needs
/// Linux 5.19; before, programs connect themselves.
class ConnectionTrap {
 public:
  /// The connected socket for a connection to `peer`; nothing: the program connects its own. Called
  /// by a thread of the trap, which the program waits for.
  using SocketFor = std::function<std::optional<base::UdpSocket>(const base::SocketAddress& peer)>;

  /// Errors are those of the system.
  static base::Result<std::unique_ptr<ConnectionTrap>> create(SocketFor socket_for);
  ~ConnectionTrap();

  /// The program of this plan is the one. The trap must outlive its start.
  void add_to(CommandPlan& plan) const;

 private:
  explicit ConnectionTrap(SocketFor socket_for) : socket_for_(std::move(socket_for)) {}

  void run();
  void receive_listener();
  void decide() const;

  SocketFor socket_for_;
  base::UniqueFd own_end_;
  base::UniqueFd child_end_;
  base::UniqueFd wake_;
  base::UniqueFd listener_;  ///< the kernel's, about the program; used by the thread
  std::thread thread_;
};

/// In a new process before exec, whose passed descriptors are in place: sends the kernel's listener
/// about its connections to the trap of the plan, if it has one. Where that is not possible nothing
/// changes.
void report_connections(const CommandPlan& plan);

}  // namespace cls::process
