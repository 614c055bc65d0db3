// A soccer server under test, and the clients that talk to it.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "orchestration/checks/check_report.h"
#include "orchestration/match/options/server_command.h"
#include "soccer/udp_channel.h"

namespace cls::orchestration::checks {

/// One client. What it was sent and has not looked at yet waits in `inbox`.
struct ServerClient {
  std::unique_ptr<soccer::Channel> channel;
  std::vector<std::string> inbox;
};

struct ServerSubject {
  std::string host;
  match::ServerPorts ports;
  std::chrono::milliseconds start_timeout{20'000};
  std::chrono::milliseconds patience{3'000};  ///< for an answer
  /// Why nothing can come of waiting for it; empty while something can.
  std::function<std::string()> hopeless;

  std::unique_ptr<soccer::UdpClients> player_door;
  std::unique_ptr<soccer::UdpClients> trainer_door;
  std::unique_ptr<soccer::UdpClients> coach_door;
  /// In the order in which they came: 0 first player, 1 goalie of the same team, 2... the others.
  std::vector<std::unique_ptr<ServerClient>> clients;
  int thinks = 0;  ///< how often the server asked in synch mode

  ServerClient& player() { return *clients[0]; }
  ServerClient& goalie() { return *clients[1]; }

  /// A client that sends this first.
  ServerClient& connect(soccer::UdpClients& door, const std::string& first);

  /// Reads for everybody, and answers every (think) with (done), until `client` has a message for
  /// which `wanted` is true; takes it. Nothing when the patience ends.
  using Wanted = std::function<bool(const std::string&)>;
  std::optional<std::string> await(ServerClient& client, const Wanted& wanted);
  std::optional<std::string> await(ServerClient& client, const Wanted& wanted,
                                   std::chrono::milliseconds longest);

  /// Reads for everybody that long.
  void listen(std::chrono::milliseconds how_long);

 private:
  bool read_all();
};

/// True for messages that begin so.
ServerSubject::Wanted begins(const std::string& text);
/// "(init" or "(error": the answer to a request.
bool is_answer(const std::string& message);

struct ServerStep {
  const char* name;
  const char* why;
  Finding (*run)(ServerSubject&);
};

// In the order in which they are taken.
std::vector<ServerStep> server_connection_steps();
std::vector<ServerStep> server_play_steps();

}  // namespace cls::orchestration::checks
