// libFuzzer target: arbitrary bytes in every parser of the text protocol.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/commands/coach_command.h"
#include "soccer/commands/connection_request.h"
#include "soccer/commands/monitor_command.h"
#include "soccer/commands/player_command.h"
#include "soccer/messages/full_state.h"
#include "soccer/messages/global_view.h"
#include "soccer/messages/hear.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"
#include "soccer/messages/server_reply.h"
#include "soccer/parameters/configuration.h"
#include "tests/fuzz/require.h"

namespace {

using namespace cls::soccer;
using cls::tests::require;

// An accepted message must format, and the text must parse to the same message.
template <typename Message, typename Write>
void check_message(std::string_view text, Write write) {
  Message message;
  if (!parse(text, message)) return;
  std::string written;
  write(message, written);
  Message again;
  require(parse(written, again).ok());
  std::string written_again;
  write(again, written_again);
  require(written == written_again);
}

template <typename Request>
void check_request(std::string_view text) {
  Request request;
  if (parse(text, request)) return;
  std::string written;
  format(request, written);
  require(!parse(written, request));
}

void check_player_commands(std::string_view text) {
  std::vector<PlayerCommand> commands;
  parse_player_commands(text, commands);
  std::string written;
  for (const PlayerCommand& command : commands) require(format(command, written));
  if (commands.empty()) return;
  std::vector<PlayerCommand> again;
  require(!parse_player_commands(written, again));
  require(again.size() == commands.size());
}

void check_coach_command(std::string_view text, CoachRole role) {
  CoachCommand command;
  if (parse(text, role, command)) return;
  std::string written;
  if (!format(command, written)) return;
  require(!parse(written, role, command));
}

void check_monitor_command(std::string_view text) {
  const auto command = parse_monitor_command(text);
  if (!command) return;
  std::string written;
  format(*command, written);
  require(parse_monitor_command(written).has_value());
}

void check_configuration(std::string_view text) {
  const auto items = parse_configuration(text);
  if (!items) return;
  for (const ConfigurationItem& item : *items) require(!item.name.empty());
}

void check_hear(std::string_view text) {
  Hear hear;
  // Some recipients get a text without quotes: there, its own quotes read as those around it.
  const bool ambiguous = parse(text, hear) && hear.text.starts_with('"');
  if (ambiguous) return;
  for (const Recipient listener :
       {Recipient::kPlayer, Recipient::kOnlineCoach, Recipient::kTrainer}) {
    check_message<Hear>(
        text, [listener](const Hear& one, std::string& out) { format(one, listener, out); });
  }
}

void check_game_request(std::string_view text) {
  GameRequest request;
  if (parse(text, request)) return;
  std::string written;
  std::visit([&written](const auto& one) { format(one, written); }, request);
  require(!parse(written, request));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto newest = [](const auto& message, std::string& out) { format(message, 19, out); };
  const auto plain = [](const auto& message, std::string& out) { format(message, out); };
  check_player_commands(text);
  check_coach_command(text, CoachRole::kOnlineCoach);
  check_coach_command(text, CoachRole::kTrainer);
  check_game_request(text);
  check_monitor_command(text);
  check_configuration(text);
  check_request<CoachInit>(text);
  check_request<TrainerInit>(text);
  check_message<SenseBody>(text, newest);
  check_message<See>(text, plain);
  check_message<FullState>(text, newest);
  check_message<GlobalView>(text, plain);
  check_message<ServerReply>(text, plain);
  check_message<ServerParams>(text, newest);
  check_message<PlayerParams>(text, newest);
  check_message<PlayerType>(text, newest);
  check_hear(text);
  return 0;
}
