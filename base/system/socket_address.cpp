// Wrappers of getaddrinfo and inet_pton.
#include "base/system/socket_address.h"

#include <arpa/inet.h>
#include <netdb.h>

#include <cstring>
#include <memory>

namespace cls::base {
namespace {

const sockaddr_in& v4(const SocketAddress& address) {
  return reinterpret_cast<const sockaddr_in&>(address.bytes);
}

const sockaddr_in6& v6(const SocketAddress& address) {
  return reinterpret_cast<const sockaddr_in6&>(address.bytes);
}

}  // namespace

int SocketAddress::port() const {
  return ntohs(family() == AF_INET6 ? v6(*this).sin6_port : v4(*this).sin_port);
}

void SocketAddress::set_port(int port) {
  const in_port_t network_order = htons(static_cast<in_port_t>(port));
  if (family() == AF_INET6) {
    reinterpret_cast<sockaddr_in6&>(bytes).sin6_port = network_order;
  } else {
    reinterpret_cast<sockaddr_in&>(bytes).sin_port = network_order;
  }
}

bool SocketAddress::same_host(const SocketAddress& other) const {
  if (family() != other.family()) return false;
  if (family() != AF_INET6) return v4(*this).sin_addr.s_addr == v4(other).sin_addr.s_addr;
  return std::memcmp(&v6(*this).sin6_addr, &v6(other).sin6_addr, sizeof(in6_addr)) == 0;
}

Result<std::vector<SocketAddress>> resolve_all(const std::string& host, int port, int family,
                                               int type) {
  addrinfo hints{};
  hints.ai_family = family;
  hints.ai_socktype = type;

  addrinfo* list = nullptr;
  const int error = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &list);
  if (error != 0) return Error{::gai_strerror(error)};
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owner(list, ::freeaddrinfo);

  std::vector<SocketAddress> addresses;
  for (const addrinfo* item = list; item != nullptr; item = item->ai_next) {
    SocketAddress& address = addresses.emplace_back();
    std::memcpy(&address.bytes, item->ai_addr, item->ai_addrlen);
    address.size = item->ai_addrlen;
  }
  return addresses;
}

Result<SocketAddress> resolve_udp(const std::string& host, int port) {
  auto found = resolve_all(host, port, AF_INET, SOCK_DGRAM);
  if (!found) found = resolve_all(host, port, AF_INET6, SOCK_DGRAM);
  if (!found) return found.error();
  return found->front();
}

Result<SocketAddress> parse_ip_address(const std::string& text, int port) {
  SocketAddress address;
  address.size = sizeof(sockaddr_in);
  address.bytes.ss_family = AF_INET;
  void* number = &reinterpret_cast<sockaddr_in&>(address.bytes).sin_addr;
  if (::inet_pton(AF_INET, text.c_str(), number) != 1) {
    address.size = sizeof(sockaddr_in6);
    address.bytes.ss_family = AF_INET6;
    number = &reinterpret_cast<sockaddr_in6&>(address.bytes).sin6_addr;
    if (::inet_pton(AF_INET6, text.c_str(), number) != 1) return Error{"not an IP address"};
  }

  address.set_port(port);
  return address;
}

std::string strip_brackets(const std::string& host) {
  const bool bracketed = host.size() > 2 && host.front() == '[' && host.back() == ']';
  return bracketed ? host.substr(1, host.size() - 2) : host;
}

std::string with_brackets(const std::string& host) {
  const bool bare = host.find(':') != std::string::npos && !host.starts_with('[');
  return bare ? "[" + host + "]" : host;
}

}  // namespace cls::base
