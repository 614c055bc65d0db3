// Taking turns with clients in memory.
#include "simulator/server/lockstep_server.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

#include "soccer/memory_channel.h"

namespace cls::simulator {

base::Result<std::unique_ptr<LockstepServer>> LockstepServer::create(MatchConfig config) {
  config.server.synch_mode = true;
  auto match = MatchServer::create(config);
  if (!match) return match.error();
  return std::unique_ptr<LockstepServer>(new LockstepServer(std::move(*match)));
}

std::unique_ptr<soccer::Channel> LockstepServer::connect(Door door) {
  auto [server_end, client_end] = soccer::make_memory_channel();
  waiting_.push_back({door, std::move(server_end)});
  return std::move(client_end);
}

void LockstepServer::answer_requests() {
  for (auto& [door, channel] : waiting_) {
    while (channel != nullptr && channel->receive(message_)) {
      const auto admission = match_->admit(door, message_);
      if (const auto* admitted = std::get_if<Admission>(&admission)) {
        match_->greet(*admitted, std::move(channel), message_);
        continue;
      }
      std::string refusal;
      soccer::format(std::get<soccer::ErrorCode>(admission), refusal);
      channel->send(refusal);
    }
  }
  const auto is_admitted = [](const Waiting& one) { return one.channel == nullptr; };
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), is_admitted), waiting_.end());
}

base::Result<int> LockstepServer::open_to_monitors(const std::string& address, int port) {
  match_->let_monitors_only_watch();
  return open(Door::kMonitors, address, port);
}

// The door of players is one for monitors too.
base::Result<int> LockstepServer::open_to_players(const std::string& address, int port) {
  match_->let_monitors_only_watch();
  return open(Door::kGame, address, port);
}

base::Result<int> LockstepServer::open(Door door, const std::string& address, int port) {
  if (network_ == nullptr) network_ = std::make_unique<UdpNetwork>(*match_);
  const auto opened = network_->open(door, address, port);
  if (!opened) return opened.error();
  return network_->port(door);
}

bool LockstepServer::wait_for_answers(Time deadline) {
  const auto enough = [this] {
    for (ClientId client = 0; client < kFirstMonitor; ++client) {
      if (awaits(client)) return false;
    }
    return true;
  };
  network_->receive_until(deadline, enough);
  return enough();
}

void LockstepServer::forget_commands() {
  for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    if (Session* player = match_->session(slot)) player->inbox.clear();
  }
}

void LockstepServer::receive_until(Time deadline) {
  network_->receive_until(deadline, [] { return false; });
}

void LockstepServer::run_cycle() {
  constexpr std::chrono::milliseconds kTimeForMonitors{2};
  if (network_ != nullptr) network_->poll(std::chrono::steady_clock::now() + kTimeForMonitors);
  answer_requests();
  for (ClientId client = 0; client < kFirstMonitor; ++client) {
    if (awaits(client)) ++missed_[static_cast<std::size_t>(client)];
  }
  match_->execute();
  match_->step();
  match_->sense();
  match_->think();
  if (network_ != nullptr) network_->flush();
}

bool LockstepServer::awaits(ClientId client) {
  collect(client);
  return match_->awaits(client);
}

void LockstepServer::collect(ClientId client) {
  Connection* connection = match_->connection(client);
  if (connection == nullptr) return;
  while (connection->channel->receive(message_)) match_->receive(client, message_);
}

}  // namespace cls::simulator
