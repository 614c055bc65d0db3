// A match whose clients are channels in memory.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/io/byte_sink.h"
#include "simulator/sessions/match_server.h"
#include "soccer/memory_channel.h"

namespace cls::simulator {

using Texts = std::vector<std::string>;

/// A fixture with a server, and the client ends of its clients.
class MatchClients : public testing::Test {
 protected:
  void start(const MatchConfig& config = {}) {
    server_ = std::move(*MatchServer::create(config));
    server_->record(&game_log_, &text_log_);
  }

  /// Connects a client; returns its id, or kNoClient with the reply in `refusal_`.
  ClientId connect(const std::string& request, ListeningPort port = ListeningPort::kPlayers,
                   const ClientRights& rights = {}) {
    const AdmissionResult result = server_->admit(port, request, rights);
    const auto* admission = std::get_if<Admission>(&result);
    refusal_.clear();
    if (admission == nullptr) {
      soccer::format(refusal(result), refusal_);
      return kNoClient;
    }

    auto [server_end, client_end] = soccer::make_memory_channel();
    clients_[admission->client] = std::move(client_end);
    server_->complete_handshake(*admission, std::move(server_end), request);
    return admission->client;
  }

  /// The messages to the client since the last call.
  Texts messages(ClientId client) {
    Texts texts;
    std::string text;
    while (clients_.at(client)->receive(text)) texts.push_back(text);
    return texts;
  }

  /// The messages to the client after its datagram.
  Texts answers(ClientId client, const std::string& datagram, bool null_terminated = true) {
    messages(client);
    server_->receive(client, datagram, null_terminated);
    server_->execute();
    return messages(client);
  }

  void step() {
    server_->step();
    server_->sense();
  }

  const World& world() const { return server_->world(); }

  base::StringSink game_log_;
  base::StringSink text_log_;
  std::unique_ptr<MatchServer> server_;
  std::map<ClientId, std::unique_ptr<soccer::Channel>> clients_;
  std::string refusal_;
};

}  // namespace cls::simulator
