// An agent's connection to the soccer server: what is the same for players, coaches and trainers.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"
#include "proxy/connection/server_trouble.h"
#include "proxy/world/world_model.h"
#include "soccer/channel.h"
#include "soccer/messages/server_reply.h"

namespace cls::proxy {

/// How far an agent has come with the server. Buffers are reused from message to message.
struct ServerConnection {
  explicit ServerConnection(std::unique_ptr<soccer::Channel> to_server)
      : channel(std::move(to_server)) {}

  std::unique_ptr<soccer::Channel> channel;
  bool admitted = false;
  int types_known = 0;  ///< player types that the server has told
  std::string refusal;  ///< its reason not to let the agent in; empty when it gave none
  ServerTrouble trouble;

  std::string message;   ///< taken last
  std::string datagram;  ///< sent last
};

/// Asks to take part: `request` is a PlayerInit, PlayerReconnect, CoachInit or TrainerInit. An
/// older refusal is forgotten. False when the connection is gone.
template <typename Request>
bool request_entry(ServerConnection& server, const Request& request) {
  server.refusal.clear();
  server.datagram.clear();
  format(request, server.datagram);
  return server.channel->send(server.datagram);
}

/// The refusal ends by itself: nobody can come back while the ball is in play.
bool refused_for_now(const ServerConnection& server);

/// True when the agent is in and knows parameters and all player types.
bool ready(const ServerConnection& server, const WorldModel& world);

/// Reads the message taken last as the kind that it is; one that does not parse is noted.
template <typename Message>
bool read(ServerConnection& server, Message& out) {
  const base::Result<void> result = parse(server.message, out);
  if (!result) server.trouble.note_unreadable(result.error().message, server.message);
  return result.ok();
}

/// The same for server_param, player_param and player_type, into the world.
bool read_parameters(ServerConnection& server, WorldModel& world);

/// What an (error ...) or (warning ...) means to any agent: before it is let in, an error is the
/// server's refusal.
void note(ServerConnection& server, const soccer::ErrorReply& error);
void note(ServerConnection& server, const soccer::WarningReply& warning);

/// Lets the server handle what it was sent (or waits for it); false to give up.
using Serve = std::function<bool()>;

/// Brings a new agent to the point where it is ready; again and again when a refusal was for the
/// moment only. The error does not say which agent it was.
template <typename Agent>
base::Result<void> enter(Agent& agent, const Serve& serve) {
  if (!agent.connect()) return base::Error{"the soccer server closed the connection"};
  while (!agent.ready()) {
    const bool go_on = serve();
    agent.perceive();
    if (refused_for_now(agent.server()) && go_on) {
      agent.connect();
    } else if (const std::string& refusal = agent.server().refusal; !refusal.empty()) {
      return base::Error{"the soccer server refused it (" + refusal + ")"};
    }
    if (!go_on && !agent.ready()) return base::Error{"the soccer server did not answer"};
  }
  return {};
}

}  // namespace cls::proxy
