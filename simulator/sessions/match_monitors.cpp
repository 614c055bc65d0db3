// What monitors send, and what they are told besides the pitch.
#include <variant>

#include "simulator/actions/monitor_action.h"
#include "simulator/actions/trainer.h"
#include "simulator/sessions/match_server.h"
#include "soccer/commands/coach_command.h"

namespace cls::simulator {
namespace {

using soccer::ErrorCode;
using soccer::WarningCode;

constexpr int kFirstStrictPlayerVersion = 8;
constexpr int kFirstMonitorVersion = 1;

template <typename Message>
std::string text_of(const Message& message) {
  std::string text;
  soccer::format(message, text);
  return text;
}

// True if it begins as one of the monitors' own commands, to the letter, whatever follows.
bool is_own_command(std::string_view datagram) {
  const auto begins = [&](std::string_view start) { return datagram.starts_with(start); };
  return begins("(dispplayer") || begins("(dispdiscard") || begins("(compression") ||
         begins("(dispfoul") || begins("(dispcard");
}

// A trainer's order as monitors may give it: told by how the datagram begins, to the letter.
std::optional<ErrorCode> read_order(std::string_view datagram, soccer::CoachCommand& out) {
  const auto begins = [&](std::string_view start) { return datagram.starts_with(start); };
  const bool moves = begins("(move");
  if (begins("(start)")) {
    out = soccer::Start{};
  } else if (begins("(recover")) {
    out = soccer::Recover{};
  } else if (begins("(check_ball")) {
    out = soccer::CheckBall{};
  } else if (moves || begins("(change_mode")) {
    const auto error = soccer::parse(datagram, soccer::CoachRole::kTrainer, out);
    if (error != ErrorCode::kUnknownCommand) return error;
    return moves ? ErrorCode::kIllegalObjectForm : ErrorCode::kIllegalCommandForm;
  } else {
    return ErrorCode::kIllegalCommandForm;
  }
  return std::nullopt;
}

}  // namespace

void MatchServer::receive_at_door(ClientId id, std::string_view datagram, bool null_terminated) {
  Connection* client = connection(id);
  if (client == nullptr) return;
  const bool strict = is_monitor(id) ? client->version != kFirstMonitorVersion
                                     : client->version >= kFirstStrictPlayerVersion;
  if (!strict) return receive(id, datagram, null_terminated);
  if (!client->allowance.take(datagram.size())) return;
  const std::string refusal = text_of(ErrorCode::kOnlyInitAllowedOnInitPort);
  if (is_monitor(id)) {
    monitors_.tell(id, world_.clock, refusal);
  } else {
    client->send(refusal);
  }
}

void MatchServer::obey_monitor(ClientId id, std::string_view datagram, bool null_terminated) {
  Connection* client = connection(id);
  if (client == nullptr || client->lost) return;
  if (!null_terminated && client->version != kFirstMonitorVersion) {
    monitors_.tell(id, world_.clock, text_of(WarningCode::kMessageNotNullTerminated));
  }
  const auto command = soccer::parse_monitor_command(datagram);
  if (!command && is_own_command(datagram)) {
    monitors_.tell(id, world_.clock, text_of(ErrorCode::kIllegalCommandForm));
  } else if (!command) {
    obey_as_trainer(id, datagram);
  } else if (std::holds_alternative<soccer::DispBye>(*command)) {
    client->lost = true;
  } else if (const auto* compression = std::get_if<soccer::Compression>(&*command)) {
    compress_monitor(*client, compression->level);
  } else if (!monitors_only_watch_) {
    apply(world_, *command, events_);
    dispatch_events();
  }
}

// Where there may be a trainer, monitors may do what moves the world too.
void MatchServer::obey_as_trainer(ClientId id, std::string_view datagram) {
  const soccer::ServerParams& params = world_.params();
  soccer::CoachCommand order;
  std::optional<ErrorCode> error = ErrorCode::kIllegalCommandForm;
  if ((params.coach || params.coach_w_referee) && !monitors_only_watch_) {
    error = read_order(datagram, order);
  }
  if (error) return monitors_.tell(id, world_.clock, text_of(*error));
  const auto answer = obey(world_, order, events_);
  dispatch_events();
  if (!answer) return;
  std::string text = text_of(*answer);
  if (text.ends_with('\n')) text.pop_back();
  monitors_.tell(id, world_.clock, text);
}

// As Connection::compress, with the answer on the board.
void MatchServer::compress_monitor(Connection& monitor, int level) {
  if (level > Connection::kMostCompression) {
    return monitors_.tell(monitor.client, world_.clock, text_of(ErrorCode::kIllegalCommandForm));
  }
  if (!monitor.channel->can_compress()) {
    return monitors_.tell(monitor.client, world_.clock,
                          text_of(WarningCode::kCompressionUnsupported));
  }
  monitors_.tell(monitor.client, world_.clock, "(ok compression " + std::to_string(level) + ')');
  monitor.channel->compress(level);
}

bool MatchServer::monitors_hear() const {
  return world_.params().send_comms && monitors_.connected() > 0;
}

void MatchServer::tell_audience(Clock clock, const CoachWords& words) {
  if (words.side == Side::kNeutral) return tell_audience(clock, "referee", words.said.text);
  const bool left = words.side == Side::kLeft;
  tell_audience(clock, left ? "online_coach_left" : "online_coach_right",
                std::to_string(words.received) + ' ' + words.said.text);
}

// Who watches: monitors, and whoever reads the game log.
void MatchServer::tell_audience(Clock clock, std::string_view speaker, std::string_view words) {
  if (!audience_hears()) return;
  std::string text = "(";
  text += speaker;
  text += ' ';
  text += words;
  text += ')';
  if (monitors_hear()) monitors_.tell(clock, text);
  recorder_.said(world_, clock, text);
}

}  // namespace cls::simulator
