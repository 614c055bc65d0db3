// An agent's connection to the soccer server, common to players, coaches and trainers.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "base/result.h"
#include "player/world/world_model.h"
#include "soccer/channel.h"
#include "soccer/messages/server_reply.h"

namespace cls::proxy {

/// Messages of the server that an agent could not use; none in a healthy match.
struct ServerErrors {
  std::int64_t unreadable = 0;   ///< messages that do not parse
  std::int64_t errors = 0;       ///< (error ...) replies
  std::int64_t warnings = 0;     ///< (warning ...) replies
  std::string first_unreadable;  ///< reason, and the beginning of the message
  std::string first_error;
  std::string first_warning;

  void add_unreadable(const std::string& reason, const std::string& message) {
    constexpr std::size_t kQuotedLength = 60;
    add(reason + ": " + message.substr(0, kQuotedLength), unreadable, first_unreadable);
  }
  void add_error(const std::string& text) { add(text, errors, first_error); }
  void add_warning(const std::string& text) { add(text, warnings, first_warning); }

 private:
  static void add(const std::string& text, std::int64_t& count, std::string& first) {
    if (count++ == 0) first = text;
  }
};

/// Connection state of an agent. Buffers are reused from message to message.
struct ServerConnection {
  explicit ServerConnection(std::unique_ptr<soccer::Channel> to_server)
      : channel(std::move(to_server)) {}

  std::unique_ptr<soccer::Channel> channel;
  bool accepted = false;
  int known_types = 0;        ///< player types received
  bool reads_values = false;  ///< the server is in this process: see and sense_body may be values
  std::string refusal;        ///< the (error ...) that rejected the init command; empty: none
  ServerErrors errors;

  std::string message;   ///< received last
  std::string datagram;  ///< sent last
};

/// Sends an init command: PlayerInit, PlayerReconnect, CoachInit or TrainerInit. Clears an earlier
/// refusal. False when the connection is closed.
template <typename Request>
bool send_init(ServerConnection& server, const Request& request) {
  server.refusal.clear();
  server.datagram.clear();
  format(request, server.datagram);
  return server.channel->send(server.datagram);
}

/// True when a later attempt may succeed: the server rejects (reconnect) during play_on.
bool is_temporary_refusal(const ServerConnection& server);

/// True when the server has accepted the agent and sent parameters and all player types.
bool ready(const ServerConnection& server, const player::WorldModel& world);

/// Parses the last message as `Message`; counts one that does not parse.
template <typename Message>
bool read(ServerConnection& server, Message& out) {
  const base::Result<void> result = parse(server.message, out);
  if (!result) server.errors.add_unreadable(result.error().message, server.message);
  return result.ok();
}

/// Reads server_param, player_param and player_type, into the world.
bool read_parameters(ServerConnection& server, player::WorldModel& world);

/// Counts an (error ...) or (warning ...). An error before acceptance is the refusal.
void handle(ServerConnection& server, const soccer::ErrorReply& error);
void handle(ServerConnection& server, const soccer::WarningReply& warning);

/// Runs the server in process, or waits for it; false to give up.
using Serve = std::function<bool()>;

/// Connects a new agent until it is ready; repeats after temporary refusals. The error does not
/// name the agent.
template <typename Agent>
base::Result<void> connect_agent(Agent& agent, const Serve& serve) {
  if (!agent.connect()) return base::Error{"the soccer server closed the connection"};
  while (!agent.ready()) {
    const bool should_continue = serve();
    agent.perceive();
    if (is_temporary_refusal(agent.server()) && should_continue) {
      agent.connect();
    } else if (const std::string& refusal = agent.server().refusal; !refusal.empty()) {
      return base::Error{"rejected by the soccer server: " + refusal};
    }
    if (!should_continue && !agent.ready()) return base::Error{"no reply from the soccer server"};
  }
  return {};
}

}  // namespace cls::proxy
