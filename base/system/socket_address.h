// IPv4 and IPv6 socket addresses, and host name lookup.
#pragma once

#include <netinet/in.h>
#include <sys/socket.h>

#include <string>
#include <vector>

#include "base/result.h"

namespace cls::base {

/// An IPv4 or IPv6 address with a port, in the form of the socket calls.
struct SocketAddress {
  sockaddr_storage bytes{};
  socklen_t size = sizeof(sockaddr_storage);

  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&bytes); }
  sockaddr* get() { return reinterpret_cast<sockaddr*>(&bytes); }

  int family() const { return bytes.ss_family; }
  int port() const;
  void set_port(int port);
  bool same_host(const SocketAddress& other) const;

  friend bool operator==(const SocketAddress& a, const SocketAddress& b) {
    return a.port() == b.port() && a.same_host(b);
  }
};

/// All addresses of `host`, a name or an IP address, in the system's order of preference (at least
/// one). `family` is AF_INET, AF_INET6 or AF_UNSPEC, `type` SOCK_STREAM or SOCK_DGRAM. Errors are
/// those of getaddrinfo.
Result<std::vector<SocketAddress>> resolve_all(const std::string& host, int port, int family,
                                               int type);

/// The UDP address of `host`. Prefers IPv4, because soccer servers listen there.
Result<SocketAddress> resolve_udp(const std::string& host, int port);

/// `text` is an IPv4 or IPv6 address; does no lookup.
Result<SocketAddress> parse_ip_address(const std::string& text, int port);

/// "::1" for "[::1]"; other hosts unchanged.
std::string strip_brackets(const std::string& host);

/// "[::1]" for "::1", as a host stands before a port; other hosts unchanged.
std::string with_brackets(const std::string& host);

}  // namespace cls::base
