// A relay between the network of one side and a soccer server that is not embedded.
#pragma once

#include <functional>
#include <memory>
#include <optional>
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
/// server's. A server that can take sockets of that network needs the relay for requests only.
/// Nothing else passes (refusal_of). Runs in a thread of its own until it is destroyed.
class ServerRelay {
 public:
  /// `names` must outlive the relay. Errors name the port that cannot be opened.
  static base::Result<std::unique_ptr<ServerRelay>> create(RelayRoute route, ClaimedNames& names);
  ~ServerRelay();

  /// A socket in the network of the side, connected to the client whose request the server has got
  /// from `sender`, a socket of this relay: with it the server reaches the client itself. Nothing:
  /// the relay must pass the messages of this client, or has no such client. Any thread.
  std::optional<base::UdpSocket> hand_over(const base::SocketAddress& sender);

  /// Lines about intrusions since the last call.
  std::vector<std::string> take_warnings();

 private:
  class Traffic;

  explicit ServerRelay(std::unique_ptr<Traffic> traffic);

  std::unique_ptr<Traffic> traffic_;
};

}  // namespace cls::match
