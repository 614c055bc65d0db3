// Playing scripts.
#include "tests/fuzz/session_script.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "base/io/byte_sink.h"
#include "simulator/sessions/match_server.h"
#include "soccer/memory_channel.h"

namespace cls::tests {
namespace {

using namespace cls::simulator;

constexpr std::size_t kLongestMessage = 8192;

void require(bool condition) {
  if (!condition) std::abort();
}

class Party {
 public:
  Party() {
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

  void ask(Door door, std::string_view request) {
    const auto answer = server_->admit(door, request);
    const auto* admission = std::get_if<Admission>(&answer);
    if (admission == nullptr) return;
    if (request.ends_with("w")) return server_->withdraw(*admission);
    auto [server_end, client_end] = soccer::make_memory_channel();
    server_->greet(*admission, std::move(server_end), request);
    clients_.push_back({admission->client, admission->binary, std::move(client_end)});
  }

  void send(char number, std::string_view datagram, bool null_terminated, bool to_door) {
    const Client* client = at(number);
    if (client == nullptr) return;
    if (to_door) {
      server_->receive_at_door(client->id, datagram, null_terminated);
    } else {
      server_->receive(client->id, datagram, null_terminated);
    }
  }

  void lose(char number) {
    if (const Client* client = at(number)) server_->lose(client->id);
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

  // A datagram is a text in brackets that fits into a client's buffer, or a block of bytes.
  void read(Client& client) {
    while (client.channel->receive(message_)) {
      require(!message_.empty() && message_.size() < kLongestMessage);
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
  Party party;
  while (!script.empty()) {
    const std::string_view line = script.substr(0, script.find('\n'));
    script.remove_prefix(std::min(line.size() + 1, script.size()));
    const char kind = line.empty() ? '.' : line[0];
    const char number = line.size() > 1 ? line[1] : '0';
    if ((kind == 'c' || kind == 'o' || kind == 't') && line.size() > 1) {
      const Door door = kind == 'c'   ? Door::kGame
                        : kind == 'o' ? Door::kOnlineCoach
                                      : Door::kOfflineCoach;
      party.ask(door, line.substr(2));
    } else if (kind >= '0' && kind <= '9') {
      party.send(kind, line.substr(std::min<std::size_t>(2, line.size())), true, false);
    } else if ((kind == '!' || kind == '=') && line.size() > 2) {
      party.send(number, line.substr(3), kind == '=', kind == '=');
    } else if (kind == 'x') {
      party.lose(number);
    } else {
      party.cycle();
    }
  }
  party.cycle();
  party.cycle();
}

}  // namespace cls::tests
