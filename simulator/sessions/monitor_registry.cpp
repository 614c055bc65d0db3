// Connects monitors, executes their commands, and sends them frames and messages.
#include "simulator/sessions/monitor_registry.h"

#include <algorithm>
#include <optional>
#include <variant>

#include "base/index.h"
#include "simulator/actions/trainer.h"
#include "simulator/sessions/match_recorder.h"
#include "soccer/commands/coach_command.h"
#include "soccer/commands/monitor_command.h"

namespace cls::simulator {
namespace {

using gamelog::MonitorVersion;
using soccer::ErrorCode;
using soccer::WarningCode;

MonitorVersion protocol_version(const Connection& monitor) {
  return static_cast<MonitorVersion>(monitor.version);
}

void send_text(Connection& monitor, Clock clock, std::string_view text, std::string& buffer) {
  buffer.clear();
  gamelog::append_monitor_text(protocol_version(monitor), clock.time, clock.stoppage, kMessageBoard,
                               text, buffer);
  monitor.send(buffer);
}

template <typename Message>
std::string formatted(const Message& message) {
  std::string text;
  soccer::format(message, text);
  return text;
}

// True if the datagram starts like a command of monitors only, case-sensitively.
bool is_monitor_command(std::string_view datagram) {
  constexpr std::string_view kStarts[] = {"(dispplayer", "(dispdiscard", "(compression",
                                          "(dispfoul", "(dispcard"};
  return std::ranges::any_of(kStarts, [&](auto start) { return datagram.starts_with(start); });
}

// Parses a trainer command that monitors may send. The command is recognized by the start of the
// datagram, case-sensitively.
std::optional<ErrorCode> parse_trainer_command(std::string_view datagram,
                                               soccer::CoachCommand& out) {
  const auto begins = [&](std::string_view start) { return datagram.starts_with(start); };
  const bool is_move = begins("(move");
  if (begins("(start)")) {
    out = soccer::Start{};
  } else if (begins("(recover")) {
    out = soccer::Recover{};
  } else if (begins("(check_ball")) {
    out = soccer::CheckBall{};
  } else if (is_move || begins("(change_mode")) {
    const auto error = soccer::parse(datagram, soccer::CoachRole::kTrainer, out);
    if (error != ErrorCode::kUnknownCommand) return error;
    return is_move ? ErrorCode::kIllegalObjectForm : ErrorCode::kIllegalCommandForm;
  } else {
    return ErrorCode::kIllegalCommandForm;
  }
  return std::nullopt;
}

}  // namespace

std::size_t MonitorRegistry::connected() const {
  return base::index(
      std::ranges::count_if(monitors_, [](const auto& one) { return one != nullptr; }));
}

Connection* MonitorRegistry::connection(ClientId id) {
  const int index = id - kFirstMonitor;
  return index >= 0 && index < std::ssize(monitors_) ? monitors_[base::index(index)].get()
                                                     : nullptr;
}

std::optional<ClientId> MonitorRegistry::admit(int limit) {
  const std::size_t max_monitors =
      limit > 0 ? std::min(base::index(limit), kMaxMonitors) : kMaxMonitors;
  if (connected() >= max_monitors) return std::nullopt;

  const auto free = std::ranges::find_if(monitors_, [](const auto& one) { return one == nullptr; });
  const auto index = free - monitors_.begin();
  if (free == monitors_.end()) monitors_.emplace_back();
  return kFirstMonitor + static_cast<ClientId>(index);
}

void MonitorRegistry::connect(ClientId id, int version, std::unique_ptr<soccer::Channel> channel,
                              const Rules& rules) {
  auto& monitor = monitors_[base::index(id - kFirstMonitor)];
  monitor = std::make_unique<Connection>();
  tiles_sent_.resize(monitors_.size());
  tiles_sent_[base::index(id - kFirstMonitor)] = 0;

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

    std::string& text = frame_text_[base::index(monitor->version + 1)];
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
  const auto found = std::ranges::find_if(tiles_, [&tile](const TeamGraphicTile& other) {
    return other.side == tile.side && other.graphic.x == tile.graphic.x &&
           other.graphic.y == tile.graphic.y;
  });
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

std::string MonitorRegistry::execute(World& world, ClientId id, std::string_view datagram,
                                     bool null_terminated, Events& events) {
  Connection* monitor = connection(id);
  if (monitor == nullptr || monitor->lost) return "";
  if (!null_terminated && monitor->version != kLenientMonitorVersion) {
    send(id, world.clock, formatted(WarningCode::kMessageNotNullTerminated));
  }

  const auto command = soccer::parse_monitor_command(datagram);
  if (!command) {
    return is_monitor_command(datagram) ? formatted(ErrorCode::kIllegalCommandForm)
                                        : execute_as_trainer(world, datagram, events);
  }

  if (std::holds_alternative<soccer::DispBye>(*command)) {
    monitor->lost = true;
  } else if (const auto* compression = std::get_if<soccer::Compression>(&*command)) {
    compress(*monitor, world.clock, compression->level);
  } else if (!read_only_) {
    apply(world, *command, events);
  }
  return "";
}

// Where a trainer is allowed, monitors may send its commands that change the world.
std::string MonitorRegistry::execute_as_trainer(World& world, std::string_view datagram,
                                                Events& events) {
  const soccer::ServerParams& params = world.params();
  soccer::CoachCommand command;
  std::optional<ErrorCode> error = ErrorCode::kIllegalCommandForm;
  if ((params.coach || params.coach_w_referee) && !read_only_) {
    error = parse_trainer_command(datagram, command);
  }
  if (error) return formatted(*error);
  const auto reply = apply(world, command, events);
  if (!reply) return "";
  std::string text = formatted(*reply);
  if (text.ends_with('\n')) text.pop_back();
  return text;
}

// Like Connection::compress, but replies on the message board.
void MonitorRegistry::compress(Connection& monitor, Clock clock, int level) {
  if (level > Connection::kMaxCompressionLevel) {
    return send(monitor.client, clock, formatted(ErrorCode::kIllegalCommandForm));
  }
  if (!monitor.channel->can_compress()) {
    return send(monitor.client, clock, formatted(WarningCode::kCompressionUnsupported));
  }
  send(monitor.client, clock, "(ok compression " + std::to_string(level) + ')');
  monitor.channel->compress(level);
}

}  // namespace cls::simulator
