// UDP connections of clients to a soccer server.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "base/result.h"
#include "base/system/socket_address.h"
#include "soccer/channel.h"

namespace cls::soccer {

/// Channels from this process to one server. The server answers each client from a separate port
/// (docs/spec/server-protocol.md 1.1): a channel sends to the well-known port until a message
/// arrives from another port, and from then on uses that port only. Messages from other hosts are
/// ignored. An object and its channels must be used on one thread.
class UdpClients {
 public:
  /// `host` is a name or an IP address; prefers IPv4. The error names host and cause. Sends
  /// nothing.
  static base::Result<std::unique_ptr<UdpClients>> create(const std::string& host, int port);
  /// Channels may outlive the object, but after read_on_thread() receive no further messages.
  ~UdpClients();

  /// From now on a thread reads the sockets and records arrival times, for real-time matches. Until
  /// then receive() reads, which is faster if the server waits for the client. After receive() has
  /// returned false it reads again when wait_until() has seen a message.
  void read_on_thread();

  /// Opens a socket. Null if the system has no sockets left. send() returns false once the server's
  /// port is known to be closed. `port` is another port of the same server; 0: the one of create().
  std::unique_ptr<Channel> connect(int port = 0);

  /// Waits for a new message or a closed connection; false after `deadline`. Without the thread it
  /// returns true as long as any message waits.
  bool wait_until(std::chrono::steady_clock::time_point deadline);

  /// Channels to the same server whose wait_until() does not see the messages of these. Null if the
  /// system has no file descriptor left.
  std::unique_ptr<UdpClients> beside() const;

 private:
  struct Sockets;

  static std::unique_ptr<UdpClients> of(const base::SocketAddress& server);
  explicit UdpClients(std::shared_ptr<Sockets> sockets);

  std::shared_ptr<Sockets> sockets_;
};

}  // namespace cls::soccer
