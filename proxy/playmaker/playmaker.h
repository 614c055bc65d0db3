// A team's view of its Playmaker: RPCs as data, calls in flight together.
#pragma once

#include <google/protobuf/message.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "player/world/match_parameters.h"
#include "player/world/world_model.h"
#include "proto/playmaker.pb.h"
#include "proto/rpc.h"
#include "proxy/playmaker/rpc_status.h"

namespace cls::proxy {

class TensorCodec;

/// Agents of a team are numbered by the uniform number of their Register call. 0 is the team
/// itself, in the RPCs of TeamPlaymaker.
constexpr int kTeamNumber = 0;
using proto::kCoachNumber;
using proto::kTrainerNumber;
constexpr int kAgentNumbers = 14;  ///< size of arrays by agent number

/// Timeout of a call. kNoTimeout waits as long as the connection lives.
using RpcTimeout = std::chrono::milliseconds;
constexpr RpcTimeout kNoTimeout = RpcTimeout::max();
/// Least time for Register during a match: it may take longer than a cycle of real time, whose
/// decision is then missed.
constexpr RpcTimeout kRegisterTimeout{1000};

/// The reply to one call.
struct Reply {
  int agent = 0;
  proto::Rpc rpc = proto::Rpc::kRegister;
  RpcStatus status;
  /// A message of the RPC's reply type; null unless `status` is ok. Owned by the Playmaker, valid
  /// until the next call of this agent.
  const google::protobuf::Message* message = nullptr;
  std::chrono::microseconds latency{0};  ///< from begin() or call() until the reply arrived

  /// The message as `T`; null when the call failed or the RPC replies with another type.
  template <typename T>
  const T* as() const {
    const bool is_t = message != nullptr && message->GetDescriptor() == T::descriptor();
    return is_t ? static_cast<const T*>(message) : nullptr;
  }
};

/// Registrations of the agents of a team.
struct TeamRegistration {
  std::vector<std::pair<int, protos::RegisterRequest>> agents;  ///< by agent number, ascending
  std::shared_ptr<const player::MatchParameters> parameters;
  std::shared_ptr<TensorCodec> codec{};  ///< null: the form TENSOR is not offered
  /// The world of the due decision of a player; needed with a codec.
  std::function<const player::WorldModel&(int agent)> world_of{};
  bool rated = false;  ///< a match of a tournament or comparison
};

/// Client of one Playmaker for all agents of a team. Used by one thread; only cancel() may be
/// called from others.
class Playmaker {
 public:
  virtual ~Playmaker() = default;

  /// Before the first Register: who will register. For Playmakers that take one call per team.
  virtual void announce_team(TeamRegistration /*team*/) {}

  /// Starts a call; at most one per agent may be outstanding. `request` is serialized before the
  /// function returns. All outstanding calls are in flight together. With `wait_for_ready`, waits
  /// for the Playmaker to come up, up to `timeout`.
  virtual void begin(int agent, proto::Rpc rpc, const google::protobuf::Message& request,
                     RpcTimeout timeout, bool wait_for_ready = false) = 0;

  /// After the begin() calls of a cycle: no more will follow before their replies. A Playmaker that
  /// collects calls sends them now.
  virtual void send() {}

  /// Makes a call and blocks until its reply; no other call may be outstanding. Register waits for
  /// the Playmaker to come up, up to `timeout`.
  virtual Reply call(int agent, proto::Rpc rpc, const google::protobuf::Message& request,
                     RpcTimeout timeout) = 0;

  /// True once after the connection over which this agent received replies was lost. A restarted
  /// Playmaker, which does not know the agent, may listen at its other end now.
  virtual bool take_connection_loss(int agent) = 0;

  /// Waits for any outstanding call and returns its reply; nullopt when none is outstanding.
  /// Replies arrive in any order.
  virtual std::optional<Reply> next_reply() = 0;

  /// As next_reply(), but also nullopt when no reply arrives within `timeout`.
  virtual std::optional<Reply> next_reply_within(std::chrono::microseconds timeout) = 0;

  /// A warning about the Playmaker since the last call of this function; empty: none.
  virtual std::string take_warning() { return {}; }

  /// Cancels calls in flight and fails later ones with kCancelled, except SendByeCommand. Thread
  /// safe.
  virtual void cancel() = 0;
};

}  // namespace cls::proxy
