// A client of the soccer server that a Playmaker decides for: a player, a coach or a trainer.
#pragma once

#include <memory>
#include <utility>

#include "player/world/world_model.h"
#include "proto/playmaker.pb.h"
#include "proxy/connection/agent_statistics.h"
#include "proxy/connection/server_connection.h"

namespace cls::proxy {

class Agent {
 public:
  /// True when the server has accepted the agent and sent parameters and all player types.
  bool ready() const { return proxy::ready(server_, world_); }
  const ServerConnection& server() const { return server_; }
  const player::WorldModel& world() const { return world_; }

  /// The last State; the caller sets its register_response.
  protos::State& mutable_state() { return state_; }
  /// Identity assigned by the Playmaker; part of every State.
  const protos::RegisterResponse& identity() const { return state_.register_response(); }
  bool has_identity() const { return state_.has_register_response(); }

  AgentStatistics& statistics() { return statistics_; }
  const AgentStatistics& statistics() const { return statistics_; }

 protected:
  explicit Agent(std::unique_ptr<soccer::Channel> channel) : server_(std::move(channel)) {}

  ServerConnection server_;
  player::WorldModel world_;
  AgentStatistics statistics_;
  protos::State state_;
};

}  // namespace cls::proxy
