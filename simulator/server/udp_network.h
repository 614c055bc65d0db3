// UDP sockets of a soccer server: one listening port per kind of client, one socket per client.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"
#include "base/system/socket_address.h"
#include "base/system/udp_socket.h"
#include "simulator/sessions/match_server.h"

namespace cls::simulator {

/// A network other than that of this process, with clients of one side.
struct OtherNetwork {
  /// A socket there, bound to a local address. Errors are those of the system.
  std::function<base::Result<base::UdpSocket>(const base::SocketAddress&)> bind;
  ClientRights rights;
  /// Called with each request beyond these rights.
  std::function<void(const base::SocketAddress&, std::string_view request)> on_intrusion = {};
};

/// Passes datagrams between the network and a match: connection requests to MatchServer::admit,
/// datagrams of clients to MatchServer::receive. Each client has a socket of its own
/// (docs/spec/server-protocol.md 1.1), owned by its connection in the match. Messages are sent by
/// flush(), and when receive_until() waits. Used on one thread.
class UdpNetwork {
 public:
  using Time = std::chrono::steady_clock::time_point;

  virtual ~UdpNetwork() = default;

  /// The rights of the process that sends from an address of this host.
  using RightsOf = std::function<ClientRights(const base::SocketAddress&)>;
  /// Called with each request beyond the rights of its sender.
  using OnIntrusion = std::function<void(const base::SocketAddress&, std::string_view request)>;
  /// From now on admits clients by the rights of their processes, but for those of other networks.
  /// `rights_of` is called for each connection request.
  virtual void bind_clients(RightsOf rights_of, OnIntrusion on_intrusion) = 0;

  /// Listens for requests. `address` is numeric; port 0 selects a free port. The error names both.
  virtual base::Result<void> open(ListeningPort role, const std::string& address, int port) = 0;

  /// Listens in another network for the clients with these rights only; no other request arrives
  /// there. Their processes are not asked for.
  virtual base::Result<void> open_in(const OtherNetwork& network, ListeningPort role,
                                     const std::string& address, int port) = 0;

  /// Number of an open port in the network of this process.
  virtual int port(ListeningPort role) const = 0;

  /// Receives pending datagrams, until `deadline`: a flood must not delay the match.
  virtual void poll(Time deadline) = 0;

  /// Receives datagrams until `deadline` or until `enough()`. Receives pending datagrams even if
  /// `enough()` is true immediately.
  virtual void receive_until(Time deadline, const std::function<bool()>& enough) = 0;

  /// Sends the messages queued since the last flush.
  virtual void flush() = 0;
};

/// The match must outlive the network, and must close its connections before the network is
/// destroyed (MatchServer::disconnect_all).
std::unique_ptr<UdpNetwork> make_udp_network(MatchServer& match);

}  // namespace cls::simulator
