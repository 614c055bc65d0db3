// Runs a match in lockstep with clients in memory or on UDP.
#include "simulator/server/lockstep_server.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

#include "base/index.h"
#include "soccer/memory_channel.h"

namespace cls::simulator {

base::Result<std::unique_ptr<LockstepServer>> LockstepServer::create(MatchConfig config) {
  config.server.synch_mode = true;
  TRY_INIT(auto match, MatchServer::create(config));
  return std::unique_ptr<LockstepServer>(new LockstepServer(std::move(match)));
}

std::unique_ptr<soccer::Channel> LockstepServer::connect(ListeningPort port,
                                                         const ClientRights& rights) {
  auto [server_end, client_end] = soccer::make_memory_channel();
  pending_.push_back({port, std::move(server_end), rights});
  return std::move(client_end);
}

void LockstepServer::accept_clients() {
  for (auto& [port, channel, rights] : pending_) {
    while (channel != nullptr && channel->receive(message_)) {
      const AdmissionResult admission = match_->admit(port, message_, rights);
      if (const auto* admitted = std::get_if<Admission>(&admission)) {
        match_->complete_handshake(*admitted, std::move(channel), message_);
        continue;
      }
      std::string reply;
      soccer::format(refusal(admission), reply);
      channel->send(reply);
    }
  }
  std::erase_if(pending_, [](const PendingConnection& each) { return each.channel == nullptr; });
}

base::Result<int> LockstepServer::open_monitor_port(const std::string& address, int port) {
  match_->make_monitors_read_only();
  return open(ListeningPort::kMonitors, address, port);
}

// Monitors connect to the port of players too.
base::Result<int> LockstepServer::open_player_port(const std::string& address, int port) {
  match_->make_monitors_read_only();
  return open(ListeningPort::kPlayers, address, port);
}

base::Result<void> LockstepServer::open_player_port_in(const OtherNetwork& network,
                                                       const std::string& address, int port) {
  if (network_ == nullptr) network_ = make_udp_network(*match_);
  return network_->open_in(network, ListeningPort::kPlayers, address, port);
}

base::Result<int> LockstepServer::open(ListeningPort role, const std::string& address, int port) {
  if (network_ == nullptr) network_ = make_udp_network(*match_);
  TRY(network_->open(role, address, port));
  return network_->port(role);
}

bool LockstepServer::wait_for_clients(Time deadline) {
  const auto no_client_awaited = [this] {
    for (ClientId client = 0; client < kFirstMonitor; ++client) {
      if (awaits(client)) return false;
    }
    return true;
  };
  network_->receive_until(deadline, no_client_awaited);
  return no_client_awaited();
}

void LockstepServer::discard_commands() {
  for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    if (PlayerSession* player = match_->session(slot)) player->inbox.clear();
  }
}

void LockstepServer::receive_until(Time deadline) {
  network_->receive_until(deadline, [] { return false; });
}

void LockstepServer::run_cycle(const Change& after_step) {
  constexpr std::chrono::milliseconds kMonitorPollLimit{2};
  if (network_ != nullptr) network_->poll(std::chrono::steady_clock::now() + kMonitorPollLimit);
  accept_clients();
  for (ClientId client = 0; client < kFirstMonitor; ++client) {
    if (awaits(client)) ++missed_[base::index(client)];
  }
  match_->execute();
  match_->step();
  if (after_step) match_->modify_world(after_step);
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
