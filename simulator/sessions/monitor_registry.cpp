// Connects monitors and sends them frames and messages.
#include "simulator/sessions/monitor_registry.h"

#include <algorithm>

#include "simulator/sessions/match_recorder.h"

namespace cls::simulator {
namespace {

using gamelog::MonitorVersion;

MonitorVersion protocol_version(const Connection& monitor) {
  return static_cast<MonitorVersion>(monitor.version);
}

void send_text(Connection& monitor, Clock clock, std::string_view text, std::string& buffer) {
  buffer.clear();
  gamelog::append_monitor_text(protocol_version(monitor), clock.time, clock.stoppage, kMessageBoard,
                               text, buffer);
  monitor.send(buffer);
}

}  // namespace

std::size_t MonitorRegistry::connected() const {
  return static_cast<std::size_t>(std::count_if(monitors_.begin(), monitors_.end(),
                                                [](const auto& one) { return one != nullptr; }));
}

Connection* MonitorRegistry::connection(ClientId id) {
  const auto index = static_cast<std::size_t>(id - kFirstMonitor);
  return id >= kFirstMonitor && index < monitors_.size() ? monitors_[index].get() : nullptr;
}

std::optional<ClientId> MonitorRegistry::admit(int limit) {
  const std::size_t max_monitors =
      limit > 0 ? std::min<std::size_t>(static_cast<std::size_t>(limit), kMaxMonitors)
                : kMaxMonitors;
  if (connected() >= max_monitors) return std::nullopt;

  const auto free = std::find(monitors_.begin(), monitors_.end(), nullptr);
  const auto index = free - monitors_.begin();
  if (free == monitors_.end()) monitors_.emplace_back();
  return kFirstMonitor + static_cast<ClientId>(index);
}

void MonitorRegistry::connect(ClientId id, int version, std::unique_ptr<soccer::Channel> channel,
                              const Rules& rules) {
  auto& monitor = monitors_[static_cast<std::size_t>(id - kFirstMonitor)];
  monitor = std::make_unique<Connection>();
  tiles_sent_.resize(monitors_.size());
  tiles_sent_[static_cast<std::size_t>(id - kFirstMonitor)] = 0;

  monitor->client = id;
  monitor->version = version;
  monitor->channel = std::move(channel);

  gamelog::send_monitor_parameters(protocol_version(*monitor), rules.server, rules.player,
                                   rules.types,
                                   [&](std::string_view message) { monitor->send(message); });
}

void MonitorRegistry::begin_step() {
  for (auto& monitor : monitors_) {
    if (monitor != nullptr) monitor->begin_step();
  }
}

void MonitorRegistry::send_frame(const World& world) {
  if (connected() == 0) return;

  to_frame(world, frame_);
  for (std::string& text : frame_text_) text.clear();

  for (std::size_t index = 0; index < monitors_.size(); ++index) {
    Connection* monitor = monitors_[index].get();
    if (monitor == nullptr) continue;

    std::string& text = frame_text_[static_cast<std::size_t>(monitor->version + 1)];
    if (text.empty()) gamelog::append_monitor_show(protocol_version(*monitor), frame_, text);
    monitor->send(text);
    send_tiles(index, world);
  }
}

// Sends a few tiles per step, so that no socket buffer overflows.
void MonitorRegistry::send_tiles(std::size_t index, const World& world) {
  constexpr std::size_t kTilesBeforeKickOff = 32;
  constexpr std::size_t kTilesInPlay = 8;
  std::size_t& sent = tiles_sent_[index];

  const std::size_t max_tiles =
      world.mode == PlayMode::kBeforeKickOff ? kTilesBeforeKickOff : kTilesInPlay;
  const std::size_t end = std::min(tiles_.size(), sent + max_tiles);
  for (; sent < end; ++sent) {
    send_text(*monitors_[index], world.clock, format_tile(tiles_[sent]), text_);
  }
}

void MonitorRegistry::add_tile(const TeamGraphicTile& tile) {
  const auto is_same_position = [&tile](const TeamGraphicTile& other) {
    return other.side == tile.side && other.graphic.x == tile.graphic.x &&
           other.graphic.y == tile.graphic.y;
  };
  const auto found = std::find_if(tiles_.begin(), tiles_.end(), is_same_position);
  if (found != tiles_.end()) {
    *found = tile;
  } else if (tiles_.size() < kMaxTiles) {
    tiles_.push_back(tile);
  }
}

void MonitorRegistry::send_to_all(Clock clock, std::string_view text) {
  for (auto& monitor : monitors_) {
    if (monitor != nullptr) send_text(*monitor, clock, text, text_);
  }
}

void MonitorRegistry::send(ClientId id, Clock clock, std::string_view text) {
  if (Connection* monitor = connection(id)) send_text(*monitor, clock, text, text_);
}

void MonitorRegistry::remove_lost() {
  for (auto& monitor : monitors_) {
    if (monitor != nullptr && monitor->lost) monitor.reset();
  }
}

}  // namespace cls::simulator
