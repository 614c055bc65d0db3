// Plays session scripts.
#include "tests/fuzz/session_script.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "base/io/byte_sink.h"
#include "simulator/sessions/match_server.h"
#include "soccer/memory_channel.h"
#include "tests/fuzz/require.h"

namespace cls::tests {
namespace {

using namespace cls::simulator;

constexpr std::size_t kMaxMessageLength = 8192;

class ScriptedSessions {
 public:
  ScriptedSessions() {
    MatchConfig config;
    config.seed = 1;
    config.server.auto_mode = true;
    config.server.kick_off_wait = 2;
    config.server.connect_wait = 4;
    config.server.half_time = 2;
    config.server.send_comms = true;
    config.server.coach_w_referee = true;
    config.server.fullstate_l = true;
    server_ = std::move(*MatchServer::create(config));
    server_->record(&game_log_, &text_log_);
  }

  void request_admission(ListeningPort port, std::string_view request) {
    const auto result = server_->admit(port, request);
    const auto* admission = std::get_if<Admission>(&result);
    if (admission == nullptr) return;
    if (request.ends_with("w")) return server_->cancel(*admission);
    auto [server_end, client_end] = soccer::make_memory_channel();
    server_->complete_handshake(*admission, std::move(server_end), request);
    clients_.push_back({admission->client, admission->binary, std::move(client_end)});
  }

  void send(char number, std::string_view datagram, bool null_terminated, bool to_listening_port) {
    const Client* client = at(number);
    if (client == nullptr) return;
    if (to_listening_port) {
      server_->receive_on_listening_port(client->id, datagram, null_terminated);
    } else {
      server_->receive(client->id, datagram, null_terminated);
    }
  }

  void disconnect(char number) {
    if (const Client* client = at(number)) server_->mark_lost(client->id);
  }

  void cycle() {
    server_->execute();
    server_->step();
    server_->sense();
    server_->think();
    for (Client& client : clients_) read(client);
    clients_.erase(std::remove_if(clients_.begin(), clients_.end(),
                                  [this](const Client& client) {
                                    return server_->connection(client.id) == nullptr;
                                  }),
                   clients_.end());
  }

 private:
  struct Client {
    ClientId id;
    bool binary;
    std::unique_ptr<soccer::Channel> channel;
  };

  const Client* at(char number) const {
    if (clients_.empty()) return nullptr;
    return &clients_[static_cast<unsigned char>(number) % clients_.size()];
  }

  // A message is a text in parentheses that fits into a client's buffer, or binary.
  void read(Client& client) {
    while (client.channel->receive(message_)) {
      require(!message_.empty() && message_.size() < kMaxMessageLength);
      if (client.binary) continue;
      require(message_.find('\0') == std::string::npos);
      require(message_.front() == '(' || message_.front() == '{');
    }
  }

  std::unique_ptr<MatchServer> server_;
  base::StringSink game_log_;
  base::StringSink text_log_;
  std::vector<Client> clients_;
  std::string message_;
};

}  // namespace

void play_session_script(std::string_view script) {
  ScriptedSessions sessions;
  while (!script.empty()) {
    const std::string_view line = script.substr(0, script.find('\n'));
    script.remove_prefix(std::min(line.size() + 1, script.size()));
    const char kind = line.empty() ? '.' : line[0];
    const char number = line.size() > 1 ? line[1] : '0';
    if ((kind == 'c' || kind == 'o' || kind == 't') && line.size() > 1) {
      const ListeningPort port = kind == 'c'   ? ListeningPort::kPlayers
                                 : kind == 'o' ? ListeningPort::kOnlineCoaches
                                               : ListeningPort::kTrainers;
      sessions.request_admission(port, line.substr(2));
    } else if (kind >= '0' && kind <= '9') {
      sessions.send(kind, line.substr(std::min<std::size_t>(2, line.size())), true, false);
    } else if ((kind == '!' || kind == '=') && line.size() > 2) {
      sessions.send(number, line.substr(3), kind == '=', kind == '=');
    } else if (kind == 'x') {
      sessions.disconnect(number);
    } else {
      sessions.cycle();
    }
  }

  sessions.cycle();
  sessions.cycle();
}

}  // namespace cls::tests
