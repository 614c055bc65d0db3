// Serving monitors.
#include "simulator/sessions/monitor_desk.h"

#include <algorithm>

#include "simulator/sessions/match_recorder.h"

namespace cls::simulator {
namespace {

using gamelog::MonitorVersion;

MonitorVersion version_of(const Connection& monitor) {
  return static_cast<MonitorVersion>(monitor.version);
}

void send_text(Connection& monitor, Clock clock, std::string_view text, std::string& buffer) {
  buffer.clear();
  gamelog::append_monitor_text(version_of(monitor), clock.time, clock.stoppage, kMessageBoard, text,
                               buffer);
  monitor.send(buffer);
}

}  // namespace

std::size_t MonitorDesk::connected() const {
  return static_cast<std::size_t>(std::count_if(monitors_.begin(), monitors_.end(),
                                                [](const auto& one) { return one != nullptr; }));
}

Connection* MonitorDesk::connection(ClientId id) {
  const auto index = static_cast<std::size_t>(id - kFirstMonitor);
  return id >= kFirstMonitor && index < monitors_.size() ? monitors_[index].get() : nullptr;
}

std::optional<ClientId> MonitorDesk::admit(int limit) {
  const std::size_t most =
      limit > 0 ? std::min<std::size_t>(static_cast<std::size_t>(limit), kMostMonitors)
                : kMostMonitors;
  if (connected() >= most) return std::nullopt;
  const auto free = std::find(monitors_.begin(), monitors_.end(), nullptr);
  const auto index = free - monitors_.begin();
  if (free == monitors_.end()) monitors_.emplace_back();
  return kFirstMonitor + static_cast<ClientId>(index);
}

void MonitorDesk::attach(ClientId id, int version, std::unique_ptr<soccer::Channel> channel,
                         const Rules& rules) {
  auto& monitor = monitors_[static_cast<std::size_t>(id - kFirstMonitor)];
  monitor = std::make_unique<Connection>();
  tiles_shown_.resize(monitors_.size());
  tiles_shown_[static_cast<std::size_t>(id - kFirstMonitor)] = 0;
  monitor->client = id;
  monitor->version = version;
  monitor->channel = std::move(channel);
  gamelog::introduce_to_monitor(version_of(*monitor), rules.server, rules.player, rules.types,
                                [&](std::string_view message) { monitor->send(message); });
}

void MonitorDesk::begin_step() {
  for (auto& monitor : monitors_) {
    if (monitor != nullptr) monitor->begin_step();
  }
}

void MonitorDesk::show(const World& world) {
  if (connected() == 0) return;
  describe(world, frame_);
  for (std::string& text : shows_) text.clear();
  for (std::size_t seat = 0; seat < monitors_.size(); ++seat) {
    Connection* monitor = monitors_[seat].get();
    if (monitor == nullptr) continue;
    std::string& text = shows_[static_cast<std::size_t>(monitor->version + 1)];
    if (text.empty()) gamelog::append_monitor_show(version_of(*monitor), frame_, text);
    monitor->send(text);
    show_tiles(seat, world);
  }
}

// Some in each step, so that no monitor's buffer overflows.
void MonitorDesk::show_tiles(std::size_t seat, const World& world) {
  constexpr std::size_t kBeforeKickOff = 32;
  constexpr std::size_t kInPlay = 8;
  std::size_t& shown = tiles_shown_[seat];
  const std::size_t most = world.mode == PlayMode::kBeforeKickOff ? kBeforeKickOff : kInPlay;
  const std::size_t end = std::min(tiles_.size(), shown + most);
  for (; shown < end; ++shown) {
    send_text(*monitors_[seat], world.clock, text_of(tiles_[shown]), text_);
  }
}

void MonitorDesk::add(const Tile& tile) {
  const auto same_place = [&tile](const Tile& other) {
    return other.side == tile.side && other.graphic.x == tile.graphic.x &&
           other.graphic.y == tile.graphic.y;
  };
  const auto found = std::find_if(tiles_.begin(), tiles_.end(), same_place);
  if (found != tiles_.end()) {
    *found = tile;
  } else if (tiles_.size() < kMostTiles) {
    tiles_.push_back(tile);
  }
}

void MonitorDesk::tell(Clock clock, std::string_view text) {
  for (auto& monitor : monitors_) {
    if (monitor != nullptr) send_text(*monitor, clock, text, text_);
  }
}

void MonitorDesk::tell(ClientId id, Clock clock, std::string_view text) {
  if (Connection* monitor = connection(id)) send_text(*monitor, clock, text, text_);
}

void MonitorDesk::remove_lost() {
  for (auto& monitor : monitors_) {
    if (monitor != nullptr && monitor->lost) monitor.reset();
  }
}

}  // namespace cls::simulator
