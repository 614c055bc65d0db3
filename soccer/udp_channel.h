// Connections of clients to a soccer server over UDP.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "base/result.h"
#include "soccer/channel.h"

namespace cls::soccer {

/// Channels from this process to one server. The server answers each client from a port of its own
/// (protocol 1.1): a channel talks to the well-known port until a message comes from another one,
/// and to that one only from then on. Messages that do not come from the server's address are
/// ignored. One thread uses an object and all its channels.
class UdpClients {
 public:
  /// `host` is a name or a number; IPv4 is preferred, as soccer servers listen there. The error
  /// names host and cause. Nothing is sent yet.
  static base::Result<std::unique_ptr<UdpClients>> create(const std::string& host, int port);
  /// Channels may outlive the object; after read_on_thread() they receive nothing more then.
  ~UdpClients();

  /// From now on a thread of their own reads the sockets, and notes when each message came: for
  /// real time. Before, receive() reads, which is quicker where the server waits for us.
  void read_on_thread();

  /// A new socket. send() is false once the server's port is known to be closed. Null when the
  /// system has no socket left. `port`: another door of the same server; 0: the one it was made
  /// for.
  std::unique_ptr<Channel> connect(int port = 0);

  /// Waits until a message arrives that no earlier call has reported, or a connection turns out to
  /// be gone; false when `deadline` passes first. Without a thread: true while any message waits.
  bool wait_until(std::chrono::steady_clock::time_point deadline);

 private:
  struct Sockets;

  explicit UdpClients(std::shared_ptr<Sockets> sockets);

  std::shared_ptr<Sockets> sockets_;
};

}  // namespace cls::soccer
