// Addresses of both families.
#include "base/system/udp_address.h"

#include <arpa/inet.h>
#include <netdb.h>

#include <cstring>

namespace cls::base {
namespace {

const sockaddr_in& v4(const UdpAddress& address) {
  return reinterpret_cast<const sockaddr_in&>(address.bytes);
}

const sockaddr_in6& v6(const UdpAddress& address) {
  return reinterpret_cast<const sockaddr_in6&>(address.bytes);
}

bool is_v6(const UdpAddress& address) { return address.bytes.ss_family == AF_INET6; }

}  // namespace

int UdpAddress::port() const {
  return ntohs(is_v6(*this) ? v6(*this).sin6_port : v4(*this).sin_port);
}

void UdpAddress::set_port(int port) {
  const in_port_t bytes_of_port = htons(static_cast<in_port_t>(port));
  if (is_v6(*this)) {
    reinterpret_cast<sockaddr_in6&>(bytes).sin6_port = bytes_of_port;
  } else {
    reinterpret_cast<sockaddr_in&>(bytes).sin_port = bytes_of_port;
  }
}

bool UdpAddress::same_host(const UdpAddress& other) const {
  if (bytes.ss_family != other.bytes.ss_family) return false;
  if (!is_v6(*this)) return v4(*this).sin_addr.s_addr == v4(other).sin_addr.s_addr;
  return std::memcmp(&v6(*this).sin6_addr, &v6(other).sin6_addr, sizeof(in6_addr)) == 0;
}

Result<UdpAddress> find_address(const std::string& host, int port) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_DGRAM;
  int error = 0;
  for (const int family : {AF_INET, AF_INET6}) {
    hints.ai_family = family;
    addrinfo* list = nullptr;
    error = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &list);
    if (error != 0) continue;
    UdpAddress address;
    std::memcpy(&address.bytes, list->ai_addr, list->ai_addrlen);
    address.size = list->ai_addrlen;
    ::freeaddrinfo(list);
    return address;
  }
  return Error{::gai_strerror(error)};
}

Result<UdpAddress> numeric_address(const std::string& host, int port) {
  UdpAddress address;
  address.size = sizeof(sockaddr_in);
  address.bytes.ss_family = AF_INET;
  void* number = &reinterpret_cast<sockaddr_in&>(address.bytes).sin_addr;
  if (::inet_pton(AF_INET, host.c_str(), number) != 1) {
    address.size = sizeof(sockaddr_in6);
    address.bytes.ss_family = AF_INET6;
    number = &reinterpret_cast<sockaddr_in6&>(address.bytes).sin6_addr;
    if (::inet_pton(AF_INET6, host.c_str(), number) != 1) return Error{"not an IP address"};
  }
  address.set_port(port);
  return address;
}

}  // namespace cls::base
