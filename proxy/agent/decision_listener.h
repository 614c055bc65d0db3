// Observes the decisions of a team's players: what they estimated, received and sent.
#pragma once

#include <chrono>

#include "proto/playmaker.pb.h"
#include "proxy/agent/player_agent.h"
#include "proxy/playmaker/rpc_status.h"

namespace cls::proxy {

/// A decision whose commands have been sent. `agent` has the world model, the trace of the
/// execution, the plan and the commands.
struct Decision {
  const PlayerAgent& agent;
  const protos::PlayerActions* reply = nullptr;  ///< null: the decision was missed
  const RpcStatus& status;                       ///< of the call
  std::chrono::microseconds latency{0};          ///< until the reply arrived, or the call failed
};

/// Called on the thread that uses the team; the decisions of a cycle in the order of their replies.
/// The references are valid during the call only.
class DecisionListener {
 public:
  virtual ~DecisionListener() = default;
  /// The world of a decision is complete (`decision_world()`), the Playmaker has not been asked.
  virtual void before_decision(const PlayerAgent& /*agent*/) {}
  virtual void on_decision(const Decision& decision) = 0;
};

}  // namespace cls::proxy
