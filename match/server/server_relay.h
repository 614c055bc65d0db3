// A relay between the network of one side and a soccer server that is not embedded.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/system/socket_address.h"
#include "base/system/udp_socket.h"
#include "match/server/relay_gate.h"

namespace cls::match {

/// Where a relay leads from, and where to.
struct RelayRoute {
  soccer::Side side = soccer::Side::kLeft;
  /// A socket in the network of the side, bound to a local address. Called by one thread at a time.
  std::function<base::Result<base::UdpSocket>(const base::SocketAddress&)> bind;
  base::SocketAddress players;         ///< of the side: where its programs expect the server
  base::SocketAddress coaches;         ///< the same for its online coach
  base::SocketAddress server_players;  ///< of the server
  base::SocketAddress server_coaches;
};

/// Listens in the network of a side, and passes its players and its coach on to the server: each
/// client has a socket of its own toward the server, and sees a port of its own as it would see the
/// server's. Nothing else passes (refusal_of). Runs in a thread of its own until it is destroyed.
class ServerRelay {
 public:
  /// `names` must outlive the relay. Errors name the port that cannot be opened.
  static base::Result<std::unique_ptr<ServerRelay>> create(RelayRoute route, ClaimedNames& names);
  ~ServerRelay();

  /// Lines about intrusions since the last call.
  std::vector<std::string> take_warnings();

 private:
  class Traffic;

  explicit ServerRelay(std::unique_ptr<Traffic> traffic);

  std::unique_ptr<Traffic> traffic_;
};

}  // namespace cls::match
