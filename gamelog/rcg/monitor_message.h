// Messages to monitors, in every version of the monitor protocol.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gamelog/record/frame.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::gamelog {

/// Version that a monitor requests (docs/spec/server-protocol.md 1.6, 6). Versions 1 and 2 are
/// binary: datagrams of fixed size without a closing NUL.
enum class MonitorVersion { kJson = -1, k1 = 1, k2 = 2, k3 = 3, k4 = 4, k5 = 5 };

constexpr bool is_binary(MonitorVersion version) {
  return version == MonitorVersion::k1 || version == MonitorVersion::k2;
}

// Each of these appends one message.

/// ServerParams, PlayerParams or a PlayerType.
template <typename Params>
void append_monitor_parameters(MonitorVersion version, const Params& params, std::string& out);

/// Positions, play mode, teams and score.
void append_monitor_show(MonitorVersion version, const Frame& frame, std::string& out);

/// `board` 1: referee and say messages, 2: commands. Versions 1 and 2 are limited to 2047
/// characters.
void append_monitor_text(MonitorVersion version, int time, int stopped, int board,
                         std::string_view text, std::string& out);

/// Calls `send` for each message to a new monitor: parameters and player types. Version 1 gets
/// none.
template <typename Send>
void send_monitor_parameters(MonitorVersion version, const soccer::ServerParams& server,
                             const soccer::PlayerParams& player,
                             const std::vector<soccer::PlayerType>& types, Send&& send) {
  if (version == MonitorVersion::k1) return;

  std::string message;
  const auto send_one = [&](const auto& params) {
    message.clear();
    append_monitor_parameters(version, params, message);
    send(std::string_view(message));
  };

  send_one(server);
  send_one(player);
  for (const soccer::PlayerType& type : types) send_one(type);
}

}  // namespace cls::gamelog
