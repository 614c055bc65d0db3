// Where a Playmaker listens, and how it is spoken to.
#pragma once

#include <memory>
#include <string>

namespace cls::proxy {

/// What a TLS connection is made with, as PEM text.
struct TlsFiles {
  std::string authorities;  ///< who vouches for the Playmaker; empty: those of the system
  std::string certificate;  ///< ours, for a Playmaker that asks for one; empty: none
  std::string key;          ///< of our certificate
  std::string server_name;  ///< that the Playmaker's certificate must bear; empty: its host
};

/// A TCP address, or a local socket when `unix_path` is not empty.
struct GrpcTarget {
  std::string host;  ///< name, IPv4, or IPv6 in brackets
  int port = 0;
  bool port_step = false;  ///< player n asks port + n, coach and trainer port + 13
  std::string unix_path;
  std::shared_ptr<const TlsFiles> tls;  ///< null: plain text
};

/// The port of that agent.
int port_of(const GrpcTarget& target, int agent);

/// As gRPC wants it: "HOST:PORT" of that agent, or "unix:PATH".
std::string address(const GrpcTarget& target, int agent);

}  // namespace cls::proxy
