// Taking turns with clients in memory.
#include "simulator/server/lockstep_server.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "soccer/memory_channel.h"

namespace cls::simulator {

soccer::Result<std::unique_ptr<LockstepServer>> LockstepServer::create(MatchConfig config) {
  config.server.synch_mode = true;
  auto match = MatchServer::create(config);
  if (!match) return match.error();
  return std::unique_ptr<LockstepServer>(new LockstepServer(std::move(*match)));
}

std::unique_ptr<soccer::Channel> LockstepServer::connect() {
  auto [server_end, client_end] = soccer::make_memory_channel();
  waiting_.push_back(std::move(server_end));
  return std::move(client_end);
}

void LockstepServer::answer_requests() {
  for (auto& channel : waiting_) {
    while (channel != nullptr && channel->receive(message_)) {
      const auto admission = match_->admit(Door::kGame, message_);
      if (const auto* admitted = std::get_if<Admission>(&admission)) {
        match_->greet(*admitted, std::move(channel), message_);
        continue;
      }
      std::string refusal;
      soccer::format(std::get<soccer::ErrorCode>(admission), refusal);
      channel->send(refusal);
    }
  }
  waiting_.erase(std::remove(waiting_.begin(), waiting_.end(), nullptr), waiting_.end());
}

void LockstepServer::run_cycle() {
  answer_requests();
  for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    if (awaits(slot)) ++missed_[static_cast<std::size_t>(slot)];
  }
  match_->execute();
  match_->step();
  match_->sense();
  match_->think();
}

bool LockstepServer::awaits(Slot slot) {
  collect(slot);
  return match_->awaits(slot);
}

void LockstepServer::collect(Slot slot) {
  Session* client = match_->session(slot);
  if (client == nullptr) return;
  while (client->channel->receive(message_)) match_->receive(slot, message_);
}

}  // namespace cls::simulator
