// Binds the clients of a soccer server to the sides of a match, by the processes that they are.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "base/system/socket_address.h"
#include "match/terms/bound_sides.h"
#include "process/socket_owner.h"
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
  ClientBinding(const BoundSides& sides, process::SocketOwners owners)
      : sides_(sides), owners_(std::move(owners)) {}

  simulator::ClientRights rights_of(const base::SocketAddress& sender);

  /// A line about a request beyond these rights. Nothing if a line was made about this process and
  /// kind of request, or about many others.
  std::optional<std::string> intrusion_line(const base::SocketAddress& sender,
                                            std::string_view request);

 private:
  BoundSides sides_;
  process::SocketOwners owners_;
  std::set<std::string> reported_;
};

}  // namespace cls::match
