// One agent's calls to its Playmaker: handshake, decisions, and re-registration after a restart.
#pragma once

#include <bitset>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "proto/playmaker.pb.h"
#include "proto/rpc.h"
#include "proto/rpc_recording.pb.h"
#include "proxy/playmaker/handshake.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// Time limits of one decision.
struct DecisionLimits {
  RpcTimeout timeout{10'000};  ///< of all calls for the decision together; kNoTimeout: none
  bool server_waits = true;    ///< for the agent's (done): lockstep and synchronous mode
  /// While the server waits: time since the connection loss in which the Playmaker may come back.
  /// Later decisions fail immediately. `timeout` limits the wait as well.
  RpcTimeout reconnect_within{3'000};
};

/// Registers the agent again (the whole handshake) after a connection loss, after UNAVAILABLE, and
/// after 3 consecutive errors, then 6, 12, ...: the Playmaker may have restarted behind a
/// connection that stayed open. Where the server waits, a decision that meets a connection loss is
/// requested again after re-registration. In real time the handshake continues from cycle to
/// cycle. Use: request_decision(), then handle_reply() with each reply to this agent until it
/// returns true.
class PlaymakerClient {
 public:
  /// `decision` is one of the three RPCs whose request is a State.
  PlaymakerClient(int agent, proto::Rpc decision, protos::RegisterRequest registration,
                  std::shared_ptr<const player::MatchParameters> parameters);

  /// First handshake; blocks. Writes the identity into `state`.
  RpcStatus register_agent(Playmaker& playmaker, RpcTimeout timeout, protos::State& state);

  /// Begins one call. `state` must stay unchanged until the decision's reply is handled, except
  /// for its register_response, which this object sets.
  void request_decision(Playmaker& playmaker, protos::State& state, const DecisionLimits& limits);

  /// True: `reply` is the result of the decision. False: it belonged to the handshake, and another
  /// call was begun.
  bool handle_reply(Playmaker& playmaker, Reply& reply);

  /// The calls of the handshake that the Playmaker accepted, as a recording has them (step 0).
  /// `identity` is what Register returned.
  std::vector<recording::RecordedCall> recorded_handshake(
      const protos::RegisterResponse& identity) const;

  /// Number of re-registrations followed by a successful decision.
  int reconnects() const { return reconnects_; }
  /// Errors in a row that led to the last re-registration; 0: the connection was lost.
  int errors_before_reconnect() const { return errors_before_reconnect_; }
  /// Warnings since the last call of this function; empty: none.
  std::string take_warning() { return std::exchange(warning_, {}); }

 private:
  using Clock = std::chrono::steady_clock;

  enum class Registration : std::uint8_t {
    kRegistered,
    kReregistering,  ///< `handshake_` is in progress or about to begin
    kReregistered,   ///< handshake completed, no successful decision since
  };

  bool has_time() const { return limits_.timeout == kNoTimeout || Clock::now() < deadline_; }
  RpcTimeout time_left() const;
  void note_outcome(const Reply& reply);
  void begin_call(Playmaker& playmaker);
  void begin_handshake_call(Playmaker& playmaker);
  void reregister(int errors);
  void note_connection_loss();
  bool handle_handshake_reply(Playmaker& playmaker, Reply& reply);
  bool handle_decision_reply(Playmaker& playmaker, const Reply& reply);

  int agent_;
  proto::Rpc decision_;
  protos::RegisterRequest registration_request_;
  std::shared_ptr<const player::MatchParameters> parameters_;

  Registration registration_ = Registration::kRegistered;
  std::optional<Handshake> handshake_;           ///< set while kReregistering
  std::bitset<proto::kRpcs> refused_;            ///< RPCs of the handshake that failed
  bool retried_ = false;                         ///< this decision, after a connection loss
  std::optional<Clock::time_point> lost_since_;  ///< connection loss not recovered from
  int errors_ = 0;                               ///< consecutive, since the last registration
  int max_errors_;
  int reconnects_ = 0;
  int errors_before_reconnect_ = 0;
  std::string warning_;

  protos::State* state_ = nullptr;
  DecisionLimits limits_;
  Clock::time_point deadline_;
};

}  // namespace cls::proxy
