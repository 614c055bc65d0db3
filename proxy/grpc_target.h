// Where a Playmaker listens.
#pragma once

#include <string>

namespace cls::proxy {

/// A TCP address, or a local socket when `unix_path` is not empty.
struct GrpcTarget {
  std::string host;  ///< name, IPv4, or IPv6 in brackets
  int port = 0;
  bool port_step = false;  ///< player n asks port + n, coach and trainer port + 13
  std::string unix_path;
};

/// As gRPC wants it: "HOST:PORT" of that agent, or "unix:PATH".
std::string address(const GrpcTarget& target, int agent);

}  // namespace cls::proxy
