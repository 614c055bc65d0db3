// Loopback sockets for tests.
#include "tests/support/udp_client.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

namespace cls::tests {
namespace {

sockaddr_in loopback(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  return address;
}

}  // namespace

UdpClient::UdpClient(int server_port)
    : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)),
      server_port_(server_port) {
  const sockaddr_in any = loopback(0);
  if (socket_ < 0 || ::bind(socket_, reinterpret_cast<const sockaddr*>(&any), sizeof any) != 0) {
    throw std::runtime_error("no UDP socket");
  }
}

UdpClient::~UdpClient() { ::close(socket_); }

bool UdpClient::send(std::string_view message) { return send_bytes(std::string(message) + '\0'); }

bool UdpClient::send_bytes(std::string_view bytes) {
  const sockaddr_in to = loopback(server_port_);
  return ::sendto(socket_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to),
                  sizeof to) == static_cast<ssize_t>(bytes.size());
}

bool UdpClient::receive(std::string& message) {
  if (!receive_bytes(message)) return false;
  if (message.find('\0') + 1 != message.size()) throw std::runtime_error("not one NUL: " + message);
  message.pop_back();
  return true;
}

bool UdpClient::receive_bytes(std::string& bytes) {
  std::array<char, 8192> buffer;
  sockaddr_in from{};
  socklen_t size = sizeof from;
  const ssize_t count = ::recvfrom(socket_, buffer.data(), buffer.size(), 0,
                                   reinterpret_cast<sockaddr*>(&from), &size);
  if (count < 0) return false;
  server_port_ = ntohs(from.sin_port);
  bytes.assign(buffer.data(), static_cast<std::size_t>(count));
  return true;
}

int UdpClient::own_port() const {
  sockaddr_in own{};
  socklen_t size = sizeof own;
  ::getsockname(socket_, reinterpret_cast<sockaddr*>(&own), &size);
  return ntohs(own.sin_port);
}

std::string UdpClient::wait(std::chrono::milliseconds longest) {
  pollfd ready{socket_, POLLIN, 0};
  std::string message;
  if (::poll(&ready, 1, static_cast<int>(longest.count())) == 1) receive(message);
  return message;
}

std::string UdpClient::wait_bytes(std::chrono::milliseconds longest) {
  pollfd ready{socket_, POLLIN, 0};
  std::string bytes;
  if (::poll(&ready, 1, static_cast<int>(longest.count())) == 1) receive_bytes(bytes);
  return bytes;
}

}  // namespace cls::tests
