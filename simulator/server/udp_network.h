// The sockets of a soccer server: a door for each kind of client, and one socket a client.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "base/result.h"
#include "simulator/sessions/match_server.h"

namespace cls::simulator {

/// Passes datagrams between the network and a match: requests that arrive at a door to
/// MatchServer::admit, what a client sends to receive(); each client is answered from a socket of
/// its own (protocol 1.1), which the match owns by its connections. What the match says goes out
/// with flush(), or when receive_until() waits. Used on one thread.
class UdpNetwork {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// The match must outlive the network, and must drop its connections before the network goes:
  /// MatchServer::disconnect_all.
  explicit UdpNetwork(MatchServer& match);
  ~UdpNetwork();

  /// Listens for requests; `address` is a number, port 0 a free one. The error names both.
  base::Result<void> open(Door door, const std::string& address, int port);

  /// The port of an open door.
  int port(Door door) const;

  /// Takes in what has arrived, but stops at `deadline`: a flood must not hold up the match.
  void poll(Time deadline);

  /// Takes in what arrives until `deadline` or until `enough()`. What has arrived already counts
  /// even if that is so at once.
  void receive_until(Time deadline, const std::function<bool()>& enough);

  /// Sends what clients have been told since the last time.
  void flush();

 private:
  class Sockets;

  std::unique_ptr<Sockets> sockets_;
};

}  // namespace cls::simulator
