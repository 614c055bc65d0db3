// Parts of a team's decisions that soccerwindow2 gets.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "base/result.h"
#include "base/system/socket_address.h"

namespace cls::proxy {

/// The port of soccerwindow2's debug server.
inline constexpr int kDebugServerPort = 6032;

/// All off by default. Files are named TEAM-NUMBER with their extension.
struct DebugOptions {
  std::string server;  ///< of the debug server, as the user wrote it; empty: none
  std::optional<base::SocketAddress> server_address;  ///< the same, resolved
  std::string view_folder;                            ///< for the packets, as *.dcl; empty: none
  std::string log_folder;                             ///< for what Playmakers log; empty: none
  std::string log_extension = ".log";
  /// LoggerLevel bits of the texts and shapes that are logged; level 0 always is.
  std::uint32_t levels = std::numeric_limits<std::uint32_t>::max();
  int first_cycle = -1;  ///< of the debug log
  int last_cycle = std::numeric_limits<int>::max();

  bool wanted() const {
    return server_address.has_value() || !view_folder.empty() || !log_folder.empty();
  }
};

/// Reads HOST, HOST:PORT or [IPV6]:PORT. The error begins with "debug-server 'TEXT'".
base::Result<void> set_debug_server(DebugOptions& options, const std::string& text);

}  // namespace cls::proxy
