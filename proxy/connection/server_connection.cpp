// What every agent makes of the server's parameters and complaints.
#include "proxy/connection/server_connection.h"

#include "proxy/perception/perception.h"
#include "soccer/protocol/message_kind.h"

namespace cls::proxy {

bool refused_for_now(const ServerConnection& server) {
  return server.refusal == soccer::name(soccer::ErrorCode::kCannotReconnectWhilePlayOn);
}

bool ready(const ServerConnection& server, const WorldModel& world) {
  return server.admitted && server.types_known > 0 &&
         server.types_known >= world.parameters->player.player_types;
}

bool read_parameters(ServerConnection& server, WorldModel& world) {
  const base::Result<void> result = on_parameter_message(world, server.message);
  if (!result) {
    server.trouble.note_unreadable(result.error().message, server.message);
    return false;
  }
  if (soccer::message_kind(server.message) == soccer::MessageKind::kPlayerType) {
    ++server.types_known;
  }
  return true;
}

void note(ServerConnection& server, const soccer::ErrorReply& error) {
  if (!server.admitted) server.refusal = error.text;
  if (!refused_for_now(server)) server.trouble.note_error(error.text);
}

void note(ServerConnection& server, const soccer::WarningReply& warning) {
  server.trouble.note_warning(warning.text);
}

}  // namespace cls::proxy
