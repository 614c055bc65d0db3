// Executes commands of monitors.
#include <optional>
#include <variant>

#include "simulator/actions/trainer.h"
#include "simulator/sessions/monitor_registry.h"
#include "soccer/commands/coach_command.h"
#include "soccer/commands/monitor_command.h"

namespace cls::simulator {
namespace {

using soccer::ErrorCode;
using soccer::WarningCode;

template <typename Message>
std::string formatted(const Message& message) {
  std::string text;
  soccer::format(message, text);
  return text;
}

// True if the datagram starts like a command of monitors only, case-sensitively.
bool is_monitor_command(std::string_view datagram) {
  const auto begins = [&](std::string_view start) { return datagram.starts_with(start); };
  return begins("(dispplayer") || begins("(dispdiscard") || begins("(compression") ||
         begins("(dispfoul") || begins("(dispcard");
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
