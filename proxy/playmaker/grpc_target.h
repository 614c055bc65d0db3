// Address and transport of a Playmaker.
#pragma once

#include <memory>
#include <string>

#include "base/system/tcp_connect.h"

namespace cls::proxy {

/// PEM texts for a TLS connection.
struct TlsFiles {
  std::string authorities;  ///< CA certificates that verify the Playmaker; empty: system CAs
  std::string certificate;  ///< client certificate; empty: none
  std::string key;          ///< of the client certificate
  std::string server_name;  ///< expected in the Playmaker's certificate; empty: its host
};

/// A TCP address, or a Unix domain socket when `unix_path` is not empty.
struct GrpcTarget {
  std::string host;  ///< name, IPv4, or IPv6 in brackets
  int port = 0;
  bool port_step = false;  ///< player n uses port + n, coach and trainer port + 13
  std::string unix_path;
  std::shared_ptr<const TlsFiles> tls;  ///< null: no TLS
  base::TcpSocketMaker make_socket;     ///< in the Playmaker's network; empty: that of cls
};

/// Port of that agent.
inline int port_of(const GrpcTarget& target, int agent) {
  constexpr int kCoachStep = 13;
  // Coach and trainer, agents 12 and 13, share a port.
  const int step = !target.port_step ? 0 : agent > 11 ? kCoachStep : agent;
  return target.port + step;
}

/// Address of that agent for gRPC: "HOST:PORT" or "unix:PATH".
inline std::string address(const GrpcTarget& target, int agent) {
  if (!target.unix_path.empty()) return "unix:" + target.unix_path;
  return target.host + ":" + std::to_string(port_of(target, agent));
}

}  // namespace cls::proxy
