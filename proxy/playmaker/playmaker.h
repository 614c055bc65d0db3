// The seam between a team and its Playmaker: the hand-shake, and decisions asked for all at once.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "proto/playmaker.pb.h"
#include "proto/rpc.h"

namespace cls::proxy {

/// Agents of a team are named by the uniform number of their Register call.
constexpr int kCoachNumber = 12;
constexpr int kTrainerNumber = 13;
constexpr int kAgentNumbers = 14;  ///< 1 to 13 in use; size of arrays by agent number

/// How long a call may take. kNoTimeout waits as long as the connection lives.
using RpcTimeout = std::chrono::milliseconds;
constexpr RpcTimeout kNoTimeout = RpcTimeout::max();

/// How a call ended.
enum class RpcOutcome : std::uint8_t {
  kOk,
  kDeadline,       ///< no answer in time
  kUnavailable,    ///< nobody there, or the connection broke
  kUnimplemented,  ///< the Playmaker is of an older interface and lacks this call
  kProtocolError,  ///< the answer is not a message of the interface
  kCancelled,      ///< cancel() was called
  kError,          ///< the Playmaker answered with an error of its own
};
constexpr int kRpcOutcomes = 7;

std::string_view name(RpcOutcome outcome);

/// Outcome with what there is to tell a user: the gRPC status code and one line.
struct RpcStatus {
  RpcOutcome outcome = RpcOutcome::kOk;
  int code = 0;
  std::string message;

  bool ok() const { return outcome == RpcOutcome::kOk; }
};

/// The answer to one begin_...(): exactly one of the pointers is set when `status` is ok, none
/// otherwise and none for the calls of the hand-shake that answer nothing. What they point to is
/// the Playmaker's and lives until the next call for that agent.
struct Reply {
  int agent = 0;
  RpcStatus status;
  const protos::RegisterResponse* identity = nullptr;
  const protos::PlayerActions* player = nullptr;
  const protos::CoachActions* coach = nullptr;
  const protos::TrainerActions* trainer = nullptr;
  const protos::BestPlannerActionResponse* planner = nullptr;
  std::chrono::microseconds latency{0};  ///< from begin_...() until the answer was there
};

/// The Playmaker of one team as its agents see it. One thread uses it (only cancel() may come from
/// another). The calls named after what they send block; they must not be made while others are
/// outstanding.
class Playmaker {
 public:
  virtual ~Playmaker() = default;

  /// First call of an agent. Waits for the Playmaker to come up, as long as the timeout allows.
  virtual RpcStatus register_agent(int agent, const protos::RegisterRequest& request,
                                   RpcTimeout timeout, protos::RegisterResponse& response) = 0;
  virtual RpcStatus send_server_params(int agent, const protos::ServerParam& params,
                                       RpcTimeout timeout) = 0;
  virtual RpcStatus send_player_params(int agent, const protos::PlayerParam& params,
                                       RpcTimeout timeout) = 0;
  virtual RpcStatus send_player_type(int agent, const protos::PlayerType& type,
                                     RpcTimeout timeout) = 0;
  virtual RpcStatus send_init_message(int agent, const protos::InitMessage& message,
                                      RpcTimeout timeout) = 0;
  virtual RpcStatus send_bye(int agent, const protos::RegisterResponse& identity,
                             RpcTimeout timeout) = 0;

  /// Start one decision each; at most one per agent may be outstanding. The request is read
  /// before the call returns. All that are outstanding are in flight together.
  virtual void begin_player_actions(int agent, const protos::State& state, RpcTimeout timeout) = 0;
  virtual void begin_coach_actions(int agent, const protos::State& state, RpcTimeout timeout) = 0;
  virtual void begin_trainer_actions(int agent, const protos::State& state, RpcTimeout timeout) = 0;
  virtual void begin_best_planner_action(int agent, const protos::BestPlannerActionRequest& request,
                                         RpcTimeout timeout) = 0;

  /// The same for one call of the hand-shake (Register to SendInitMessage). With `wait`, for the
  /// Playmaker to come up, as long as the timeout allows.
  virtual void begin_introduction(int agent, proto::Rpc rpc,
                                  const google::protobuf::Message& request, RpcTimeout timeout,
                                  bool wait) = 0;

  /// True once after the connection over which this agent was answered has gone: at its other end
  /// there may now be a Playmaker that does not know it.
  virtual bool take_lost_connection(int agent) = 0;

  /// Waits for any outstanding call and returns its answer; nothing when none is outstanding.
  /// Replies come in any order.
  virtual std::optional<Reply> next_reply() = 0;

  /// The same, but nothing as well when no reply is there within `longest`.
  virtual std::optional<Reply> next_reply_within(std::chrono::microseconds longest) = 0;

  /// Ends the calls in flight with kCancelled, and every later one except send_bye(). May be
  /// called from any thread.
  virtual void cancel() = 0;
};

}  // namespace cls::proxy
