// A soccer server under test and its clients.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "checks/check_report.h"
#include "match/programs/server_plan.h"
#include "soccer/udp_channel.h"

namespace cls::checks {

/// One client. `inbox`: received messages that are not processed yet.
struct ServerClient {
  std::unique_ptr<soccer::Channel> channel;
  std::vector<std::string> inbox;
};

struct ServerSubject {
  std::string host;
  match::ServerPorts ports;
  std::chrono::milliseconds start_timeout{20'000};
  std::chrono::milliseconds reply_timeout{3'000};  ///< of a reply
  /// Why waiting is useless; empty while it is not.
  std::function<std::string()> failure_reason;

  std::unique_ptr<soccer::UdpClients> player_port;
  std::unique_ptr<soccer::UdpClients> trainer_port;
  std::unique_ptr<soccer::UdpClients> coach_port;
  /// In order of connection: 0 first player, 1 goalie of the same team, then the others.
  std::vector<std::unique_ptr<ServerClient>> clients;
  int thinks = 0;  ///< number of (think) messages in synch mode

  ServerClient& player() { return *clients[0]; }
  ServerClient& goalie() { return *clients[1]; }

  /// Adds a client that sends `first`.
  ServerClient& connect(soccer::UdpClients& door, const std::string& first);

  /// Reads for all clients and replies to every (think) with (done), until `client` has a message
  /// for which `wanted` is true; removes and returns it. Nothing after the timeout.
  using Wanted = std::function<bool(const std::string&)>;
  std::optional<std::string> await(ServerClient& client, const Wanted& wanted);
  std::optional<std::string> await(ServerClient& client, const Wanted& wanted,
                                   std::chrono::milliseconds timeout);

  /// Reads for all clients for this duration.
  void listen(std::chrono::milliseconds duration);

 private:
  bool read_all();
};

/// True for messages that start with `text`.
ServerSubject::Wanted starts_with_text(const std::string& text);
/// "(init" or "(error": the reply to a request.
bool is_reply(const std::string& message);

struct ServerStep {
  const char* name;
  const char* why;
  Finding (*run)(ServerSubject&);
};

// In the order of execution.
std::vector<ServerStep> server_connection_steps();
std::vector<ServerStep> server_play_steps();

}  // namespace cls::checks
