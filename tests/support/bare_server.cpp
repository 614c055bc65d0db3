// A server in memory with 22 scripted players.
#include "tests/support/bare_server.h"

#include <utility>

namespace cls::tests {

BareServer::BareServer(const simulator::MatchConfig& config, bool logs)
    : server_(std::move(*simulator::LockstepServer::create(config))) {
  if (logs) server_->record(&game_log_, &text_log_);
  const auto places = formation(true);
  for (const char* team : {"Left", "Right"}) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      players_.push_back(std::make_unique<ScriptedPlayer>(server_->connect(), team));
      players_.back()->stand_at(places[i]);
      players_.back()->join(i == 0);
      server_->accept_clients();
    }
  }
}

void BareServer::act() {
  for (auto& player : players_) player->act();
}

}  // namespace cls::tests
