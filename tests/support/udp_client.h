// A client's socket for tests: talks to a server as foreign teams do.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "soccer/channel.h"

namespace cls::tests {

/// Sends to the port of the last message received, first to the port it was made for.
class UdpClient : public soccer::Channel {
 public:
  /// Throws std::runtime_error, which fails the test, when there is no socket to be had.
  explicit UdpClient(int server_port);
  ~UdpClient() override;
  UdpClient(const UdpClient&) = delete;
  UdpClient& operator=(const UdpClient&) = delete;

  /// With the closing NUL.
  bool send(std::string_view message) override;
  /// Just these bytes.
  bool send_bytes(std::string_view bytes);

  /// Fails the test with std::runtime_error when a message does not end in exactly one NUL.
  bool receive(std::string& message) override;

  /// The datagram as it is.
  bool receive_bytes(std::string& bytes);

  // Each waits until something arrives; empty when nothing does.
  std::string wait(std::chrono::milliseconds longest = std::chrono::seconds(10));
  std::string wait_bytes(std::chrono::milliseconds longest = std::chrono::seconds(10));

  /// For poll() and its like.
  int descriptor() const { return socket_; }

  /// Where it receives.
  int own_port() const;

  /// Where it sends to now.
  int server_port() const { return server_port_; }
  /// Sends to another port from now on.
  void set_server_port(int port) { server_port_ = port; }

 private:
  int socket_;
  int server_port_;
};

}  // namespace cls::tests
