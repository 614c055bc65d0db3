// UDP sockets of a soccer server: one listening port per kind of client, one socket per client.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"
#include "base/system/socket_address.h"
#include "simulator/sessions/match_server.h"

namespace cls::simulator {

/// Passes datagrams between the network and a match: connection requests to MatchServer::admit,
/// datagrams of clients to MatchServer::receive. Each client has a socket of its own
/// (docs/spec/server-protocol.md 1.1), owned by its connection in the match. Messages are sent by
/// flush(), and when receive_until() waits. Used on one thread.
class UdpNetwork {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// The match must outlive the network, and must close its connections before the network is
  /// destroyed (MatchServer::disconnect_all).
  explicit UdpNetwork(MatchServer& match);
  ~UdpNetwork();

  /// Whose process sends from an address of this host, in terms of rights.
  using RightsOf = std::function<ClientRights(const base::SocketAddress&)>;
  /// Called with each request beyond the rights of its sender.
  using OnIntrusion = std::function<void(const base::SocketAddress&, std::string_view request)>;
  /// From now on admits clients by the rights of their processes. `rights_of` is called for each
  /// connection request.
  void bind_clients(RightsOf rights_of, OnIntrusion on_intrusion);

  /// Listens for requests. `address` is numeric; port 0 selects a free port. The error names both.
  base::Result<void> open(ListeningPort role, const std::string& address, int port);

  /// Number of an open port.
  int port(ListeningPort role) const;

  /// Receives pending datagrams, until `deadline`: a flood must not delay the match.
  void poll(Time deadline);

  /// Receives datagrams until `deadline` or until `enough()`. Receives pending datagrams even if
  /// `enough()` is true immediately.
  void receive_until(Time deadline, const std::function<bool()>& enough);

  /// Sends the messages queued since the last flush.
  void flush();

 private:
  class Sockets;

  std::unique_ptr<Sockets> sockets_;
};

}  // namespace cls::simulator
