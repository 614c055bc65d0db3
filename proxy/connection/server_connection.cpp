// Parameters, errors and warnings of the server.
#include "proxy/connection/server_connection.h"

#include "player/perception/perception.h"
#include "soccer/protocol/message_kind.h"

namespace cls::proxy {

bool is_temporary_refusal(const ServerConnection& server) {
  return server.refusal == soccer::name(soccer::ErrorCode::kCannotReconnectWhilePlayOn);
}

bool ready(const ServerConnection& server, const player::WorldModel& world) {
  return server.accepted && server.known_types > 0 &&
         server.known_types >= world.parameters->player.player_types;
}

bool read_parameters(ServerConnection& server, player::WorldModel& world) {
  const base::Result<void> result = on_parameter_message(world, server.message);
  if (!result) {
    server.errors.add_unreadable(result.error().message, server.message);
    return false;
  }
  if (soccer::message_kind(server.message) == soccer::MessageKind::kPlayerType) {
    ++server.known_types;
  }
  return true;
}

void handle(ServerConnection& server, const soccer::ErrorReply& error) {
  if (!server.accepted) server.refusal = error.text;
  if (!is_temporary_refusal(server)) server.errors.add_error(error.text);
}

void handle(ServerConnection& server, const soccer::WarningReply& warning) {
  server.errors.add_warning(warning.text);
}

}  // namespace cls::proxy
