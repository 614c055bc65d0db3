// Where datagrams come from and go to.
#pragma once

#include <netinet/in.h>
#include <sys/socket.h>

#include <string>

#include "base/result.h"

namespace cls::base {

/// An IPv4 or IPv6 address with a port, as system calls want it.
struct UdpAddress {
  sockaddr_storage bytes{};
  socklen_t size = sizeof(sockaddr_storage);

  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&bytes); }
  sockaddr* get() { return reinterpret_cast<sockaddr*>(&bytes); }

  int port() const;
  void set_port(int port);
  bool same_host(const UdpAddress& other) const;

  friend bool operator==(const UdpAddress& a, const UdpAddress& b) {
    return a.port() == b.port() && a.same_host(b);
  }
};

/// `host` is a name or a number; IPv4 is preferred, as soccer servers listen there. The error is
/// the cause in the system's words.
Result<UdpAddress> find_address(const std::string& host, int port);

/// `host` is a number; nothing is asked over a network.
Result<UdpAddress> numeric_address(const std::string& host, int port);

}  // namespace cls::base
