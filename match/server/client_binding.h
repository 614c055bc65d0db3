// Binds the clients of a soccer server to the sides of a match, by the processes that they are.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "base/system/socket_address.h"
#include "match/terms/bound_sides.h"
#include "process/namespaces.h"
#include "process/socket_owner.h"
#include "simulator/server/udp_network.h"
#include "simulator/sessions/connection.h"

namespace cls::match {

/// The side whose program that is; neutral: none, or a program of both.
soccer::Side side_of(const process::SocketOwner& owner);

/// Begins the line of a server's output about a refused intrusion.
inline constexpr std::string_view kIntrusionLine = "Intrusion: ";

/// A player or coach may play for the side whose program has opened its socket; agents of cls for
/// the sides that have no programs of their own. Programs of a side may not watch; other processes
/// of the host may do nothing else.
class ClientBinding {
 public:
  /// Without `owners`, where the system does not show them, of clients in networks of their side
  /// only.
  ClientBinding(const BoundSides& sides, std::optional<process::SocketOwners> owners)
      : sides_(sides), owners_(std::move(owners)) {}

  simulator::ClientRights rights_of(const base::SocketAddress& sender);
  /// The rights of a program of `side`, which must be an external one.
  simulator::ClientRights rights_of(soccer::Side side) const;

  /// A line about a request beyond these rights. Nothing if a line was made about this process and
  /// kind of request, or about many others.
  std::optional<std::string> intrusion_line(const base::SocketAddress& sender,
                                            std::string_view request);
  /// The same about a program of `side`, in a network of its own.
  std::optional<std::string> intrusion_line(soccer::Side side, const base::SocketAddress& sender,
                                            std::string_view request);

 private:
  std::optional<std::string> line(const std::string& who, const std::string& key, int port,
                                  std::string_view request);

  BoundSides sides_;
  std::optional<process::SocketOwners> owners_;
  std::set<std::string> reported_;
};

/// The network of a side, whose clients have no other rights than those of its programs. `report`
/// gets the lines about intrusions; `binding` and `door` must outlive the sockets.
simulator::OtherNetwork network_of(soccer::Side side, ClientBinding& binding,
                                   const process::NetworkDoor& door,
                                   std::function<void(std::string)> report);

}  // namespace cls::match
