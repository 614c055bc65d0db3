// UDP clients of tests.
#include "tests/support/udp_client.h"

#include <poll.h>

#include <array>
#include <stdexcept>

namespace cls::tests {
namespace {

base::SocketAddress loopback(int port) { return *base::parse_ip_address("127.0.0.1", port); }

base::UdpSocket bind_loopback() {
  auto socket = base::UdpSocket::bind(loopback(0));
  if (!socket) throw std::runtime_error("no UDP socket: " + socket.error().message);
  return *std::move(socket);
}

}  // namespace

UdpClient::UdpClient(int server_port) : socket_(bind_loopback()), server_port_(server_port) {}

bool UdpClient::send(std::string_view message) { return send_bytes(std::string(message) + '\0'); }

bool UdpClient::send_bytes(std::string_view bytes) {
  const base::SocketAddress server = loopback(server_port_);
  return socket_.send(bytes, false, &server) == 0;
}

bool UdpClient::receive(std::string& message) {
  if (!receive_bytes(message)) return false;
  if (message.find('\0') + 1 != message.size()) throw std::runtime_error("not one NUL: " + message);
  message.pop_back();
  return true;
}

bool UdpClient::receive_bytes(std::string& bytes) {
  std::array<char, 8192> buffer;
  base::SocketAddress sender;
  std::size_t size = 0;
  if (socket_.receive(buffer, size, sender) != 0) return false;
  server_port_ = sender.port();
  bytes.assign(buffer.data(), size);
  return true;
}

std::string UdpClient::wait(std::chrono::milliseconds longest) {
  pollfd ready{socket_.fd(), POLLIN, 0};
  std::string message;
  if (::poll(&ready, 1, static_cast<int>(longest.count())) == 1) receive(message);
  return message;
}

std::string UdpClient::wait_bytes(std::chrono::milliseconds longest) {
  pollfd ready{socket_.fd(), POLLIN, 0};
  std::string bytes;
  if (::poll(&ready, 1, static_cast<int>(longest.count())) == 1) receive_bytes(bytes);
  return bytes;
}

}  // namespace cls::tests
