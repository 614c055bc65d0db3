// The monitors that watch a match.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gamelog/rcg/monitor_message.h"
#include "gamelog/record/frame.h"
#include "simulator/sessions/session.h"
#include "simulator/sessions/tile.h"

namespace cls::simulator {

/// Boards of a monitor that messages are for.
constexpr int kMessageBoard = 1;

/// Their connections and what they are shown. Each version's message is made once a step, however
/// many watch.
class MonitorDesk {
 public:
  /// More are refused, also where the parameters know no limit.
  static constexpr std::size_t kMostMonitors = 64;

  std::size_t connected() const;

  /// The connection, until it is lost; null for another id.
  Connection* connection(ClientId id);

  /// A free seat; none when `limit` (if positive) or kMostMonitors are there.
  std::optional<ClientId> admit(int limit);

  /// Whoever takes it; sends what a monitor gets first. The version must be one of
  /// gamelog::MonitorVersion.
  void attach(ClientId id, int version, std::unique_ptr<soccer::Channel> channel,
              const Rules& rules);

  void begin_step();

  /// Every step: the world to everybody.
  void show(const World& world);

  /// A piece of a team's picture, which everybody is shown in time, also who comes later. Another
  /// one at the same place takes its place for these alone.
  void add(const Tile& tile);

  /// A message to everybody, or to one.
  void tell(Clock clock, std::string_view text);
  void tell(ClientId id, Clock clock, std::string_view text);

  void remove_lost();
  void disconnect_all() { monitors_.clear(); }

 private:
  static constexpr std::size_t kVersions = 7;      ///< places for -1 to 5
  static constexpr std::size_t kMostTiles = 1024;  ///< more than both pictures have

  void show_tiles(std::size_t seat, const World& world);

  std::vector<std::unique_ptr<Connection>> monitors_;  ///< null: a free seat
  std::vector<Tile> tiles_;
  std::vector<std::size_t> tiles_shown_;  ///< by seat
  gamelog::Frame frame_;
  std::array<std::string, kVersions> shows_;
  std::string text_;
};

}  // namespace cls::simulator
