// The monitors of a match: connections, frames, messages and commands.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gamelog/rcg/monitor_message.h"
#include "gamelog/record/frame.h"
#include "simulator/sessions/connection.h"
#include "simulator/sessions/team_graphic.h"
#include "simulator/world/event.h"

namespace cls::simulator {

/// Monitors of this version may omit the closing NUL and send commands to the listening port.
constexpr int kLenientMonitorVersion = 1;

/// Board number of messages to monitors.
constexpr int kMessageBoard = 1;

/// Part of MatchServer. The frame is formatted once per step and protocol version, for any number
/// of monitors.
class MonitorRegistry {
 public:
  /// Maximum even if the parameters set no limit.
  static constexpr std::size_t kMaxMonitors = 64;

  std::size_t connected() const;

  /// Null if the client is not connected.
  Connection* connection(ClientId id);

  /// Reserves an id; none if `limit` (if positive) or kMaxMonitors monitors are connected.
  std::optional<ClientId> admit(int limit);

  /// Connects an admitted monitor and sends the parameters. The version must be one of
  /// gamelog::MonitorVersion.
  void connect(ClientId id, int version, std::unique_ptr<soccer::Channel> channel,
               const Rules& rules);

  void begin_step();

  /// Sends the frame of a step to all monitors.
  void send_frame(const World& world);

  /// Adds a tile of a team graphic. All monitors receive it in later steps, also those that connect
  /// later. A tile replaces the former tile at the same position.
  void add_tile(const TeamGraphicTile& tile);

  /// Ignores commands that change the match from now on, so that the match stays reproducible.
  void make_read_only() { read_only_ = true; }

  /// Executes a command. The caller dispatches `events`, then sends the returned reply unless it is
  /// empty.
  std::string execute(World& world, ClientId id, std::string_view datagram, bool null_terminated,
                      Events& events);

  void send_to_all(Clock clock, std::string_view text);
  void send(ClientId id, Clock clock, std::string_view text);

  void remove_lost();
  void disconnect_all() { monitors_.clear(); }

 private:
  static constexpr std::size_t kVersions = 7;     ///< versions -1 to 5
  static constexpr std::size_t kMaxTiles = 1024;  ///< exceeds the tiles of both graphics

  std::string execute_as_trainer(World& world, std::string_view datagram, Events& events);
  void compress(Connection& monitor, Clock clock, int level);
  void send_tiles(std::size_t index, const World& world);

  std::vector<std::unique_ptr<Connection>> monitors_;  ///< null: a free id
  bool read_only_ = false;
  std::vector<TeamGraphicTile> tiles_;
  std::vector<std::size_t> tiles_sent_;  ///< by monitor
  gamelog::Frame frame_;
  std::array<std::string, kVersions> frame_text_;  ///< by version
  std::string text_;
};

}  // namespace cls::simulator
