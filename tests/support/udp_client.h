// A UDP client for tests, which talks to a server as external teams do.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "base/system/udp_socket.h"
#include "soccer/channel.h"

namespace cls::tests {

/// Sends to the port of the last received message, first to the port of the constructor.
class UdpClient : public soccer::Channel {
 public:
  /// Throws std::runtime_error, which fails the test, if no socket can be opened.
  explicit UdpClient(int server_port);

  /// Sends `text` with a closing NUL.
  bool send(std::string_view message) override;
  /// Sends exactly these bytes.
  bool send_bytes(std::string_view bytes);

  /// Throws std::runtime_error, which fails the test, if a message does not end in exactly one NUL.
  bool receive(std::string& message) override;

  /// The unmodified datagram.
  bool receive_bytes(std::string& bytes);

  // Each waits for a datagram; empty after the timeout.
  std::string wait(std::chrono::milliseconds longest = std::chrono::seconds(10));
  std::string wait_bytes(std::chrono::milliseconds longest = std::chrono::seconds(10));

  /// File descriptor for poll().
  int descriptor() const { return socket_.fd(); }

  /// Port on which it receives.
  int own_port() const { return socket_.local_port(); }

  /// Port to which it sends.
  int server_port() const { return server_port_; }
  /// Changes the port to which it sends.
  void set_server_port(int port) { server_port_ = port; }

 private:
  base::UdpSocket socket_;
  int server_port_;
};

}  // namespace cls::tests
