// Clients of a soccer server under test.
#include "checks/server/server_subject.h"

#include <algorithm>

namespace cls::checks {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

ServerClient& ServerSubject::connect(soccer::UdpClients& door, const std::string& first) {
  clients.push_back(std::make_unique<ServerClient>());
  ServerClient& client = *clients.back();
  client.channel = door.connect();
  if (client.channel != nullptr) client.channel->send(first);
  return client;
}

bool ServerSubject::read_all() {
  bool any = false;
  std::string message;
  const auto now = steady_clock::now();

  for (const auto* port : {&player_port, &trainer_port, &coach_port}) {
    if (*port != nullptr) (*port)->wait_until(now);
  }

  for (const auto& client : clients) {
    while (client->channel != nullptr && client->channel->receive(message)) {
      any = true;
      if (message.starts_with("(think")) {
        ++thinks;
        client->channel->send("(done)");
      } else {
        client->inbox.push_back(message);
      }
    }
  }
  return any;
}

std::optional<std::string> ServerSubject::await(ServerClient& client, const Wanted& wanted,
                                                milliseconds longest) {
  const auto end = steady_clock::now() + longest;
  for (;;) {
    read_all();
    const auto found = std::ranges::find_if(client.inbox, wanted);
    if (found != client.inbox.end()) {
      std::string message = std::move(*found);
      client.inbox.erase(client.inbox.begin(), found + 1);
      return message;
    }

    if (steady_clock::now() >= end) return std::nullopt;
    player_port->wait_until(std::min(end, steady_clock::now() + milliseconds(5)));
  }
}

std::optional<std::string> ServerSubject::await(ServerClient& client, const Wanted& wanted) {
  return await(client, wanted, reply_timeout);
}

void ServerSubject::listen(milliseconds duration) {
  ServerClient no_client;
  await(
      no_client, [](const std::string&) { return true; }, duration);
}

ServerSubject::Wanted starts_with_text(const std::string& text) {
  return [text](const std::string& message) { return message.starts_with(text); };
}

bool is_reply(const std::string& message) {
  return message.starts_with("(init") || message.starts_with("(error");
}

}  // namespace cls::checks
