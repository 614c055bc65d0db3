// Address and transport of a Playmaker.
#pragma once

#include <memory>
#include <string>

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
};

/// Port of that agent.
int port_of(const GrpcTarget& target, int agent);

/// Address of that agent for gRPC: "HOST:PORT" or "unix:PATH".
std::string address(const GrpcTarget& target, int agent);

}  // namespace cls::proxy
