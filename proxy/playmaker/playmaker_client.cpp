// Sequence of an agent's calls, and the meaning of failed ones.
#include "proxy/playmaker/playmaker_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/index.h"
#include "proxy/playmaker/playmaker_errors.h"
#include "proxy/playmaker/replies.h"

namespace cls::proxy {
namespace {

using proto::Rpc;

constexpr int kMaxErrors = 3;  // before the first re-registration
constexpr RpcTimeout kMinTimeout{1};

void append_once(std::string& warnings, const std::string& warning) {
  if (warnings.find(warning) != std::string::npos) return;
  if (!warnings.empty()) warnings += "; ";
  warnings += warning;
}

}  // namespace

PlaymakerClient::PlaymakerClient(int agent, Rpc decision, protos::RegisterRequest registration,
                                 std::shared_ptr<const player::MatchParameters> parameters)
    : agent_(agent),
      decision_(decision),
      registration_request_(std::move(registration)),
      parameters_(std::move(parameters)),
      max_errors_(kMaxErrors) {
  assert(is_decision(decision));
}

RpcStatus PlaymakerClient::register_agent(Playmaker& playmaker, RpcTimeout timeout,
                                          protos::State& state) {
  Handshake handshake(registration_request_, parameters_);
  for (;;) {
    const Reply reply = playmaker.call(agent_, handshake.rpc(), handshake.request(), timeout);
    note_outcome(reply);
    const Handshake::Next next = handshake.handle_reply(reply);
    if (next == Handshake::Next::kFailed) return reply.status;
    append_once(warning_, handshake.warning());
    *state.mutable_register_response() = handshake.identity();
    if (next == Handshake::Next::kComplete) return {};
  }
}

void PlaymakerClient::note_outcome(const Reply& reply) {
  refused_.set(base::index(reply.rpc), !reply.status.ok());
}

std::vector<recording::RecordedCall> PlaymakerClient::recorded_handshake(
    const protos::RegisterResponse& identity) const {
  std::vector<recording::RecordedCall> calls;
  Handshake handshake(registration_request_, parameters_);
  Reply reply;
  reply.message = &identity;

  for (auto next = Handshake::Next::kCall; next == Handshake::Next::kCall;) {
    if (!refused_.test(base::index(handshake.rpc()))) {
      calls.push_back(record_call(agent_, handshake.rpc(), 0, handshake.request()));
      if (handshake.rpc() == Rpc::kRegister) calls.back().set_reply(identity.SerializeAsString());
    }
    next = handshake.handle_reply(reply);
  }
  return calls;
}

RpcTimeout PlaymakerClient::time_left() const {
  if (limits_.timeout == kNoTimeout) return kNoTimeout;
  return std::max(kMinTimeout, std::chrono::ceil<RpcTimeout>(deadline_ - Clock::now()));
}

void PlaymakerClient::reregister(int errors) {
  errors_before_reconnect_ = errors;
  registration_ = Registration::kReregistering;
  handshake_.emplace(registration_request_, parameters_);
}

void PlaymakerClient::note_connection_loss() {
  if (!lost_since_) lost_since_ = Clock::now();
}

void PlaymakerClient::request_decision(Playmaker& playmaker, protos::State& state,
                                       const DecisionLimits& limits) {
  state_ = &state;
  limits_ = limits;
  retried_ = false;
  if (limits.timeout != kNoTimeout) deadline_ = Clock::now() + limits.timeout;
  if (playmaker.take_connection_loss(agent_)) {
    note_connection_loss();
    reregister(0);
  }
  begin_call(playmaker);
}

void PlaymakerClient::begin_call(Playmaker& playmaker) {
  if (registration_ == Registration::kReregistering) return begin_handshake_call(playmaker);
  playmaker.begin(agent_, decision_, *state_, time_left());
}

void PlaymakerClient::begin_handshake_call(Playmaker& playmaker) {
  RpcTimeout timeout = time_left();
  bool wait_for_ready = false;
  if (handshake_->rpc() == Rpc::kRegister) {
    if (!limits_.server_waits) timeout = std::max(timeout, kRegisterTimeout);
    if (limits_.server_waits && lost_since_) {
      const auto elapsed = std::chrono::duration_cast<RpcTimeout>(Clock::now() - *lost_since_);
      wait_for_ready = elapsed < limits_.reconnect_within;
      if (wait_for_ready) timeout = std::min(timeout, limits_.reconnect_within - elapsed);
    }
  }

  playmaker.begin(agent_, handshake_->rpc(), handshake_->request(), timeout, wait_for_ready);
}

bool PlaymakerClient::handle_reply(Playmaker& playmaker, Reply& reply) {
  assert(reply.agent == agent_);
  return registration_ == Registration::kReregistering ? handle_handshake_reply(playmaker, reply)
                                                       : handle_decision_reply(playmaker, reply);
}

bool PlaymakerClient::handle_handshake_reply(Playmaker& playmaker, Reply& reply) {
  note_outcome(reply);
  const Handshake::Next next = handshake_->handle_reply(reply);
  append_once(warning_, handshake_->warning());
  if (next == Handshake::Next::kFailed) {
    // After a deadline the handshake continues in the next cycle, otherwise it starts again.
    if (reply.status.outcome != RpcOutcome::kDeadline) reregister(errors_before_reconnect_);
    return true;
  }

  *state_->mutable_register_response() = handshake_->identity();
  std::string late =
      fmt::format("re-registration incomplete at the deadline of the decision ({} of {} calls)",
                  handshake_->completed_calls(), handshake_->calls());
  if (next == Handshake::Next::kComplete) {
    handshake_.reset();
    lost_since_.reset();
    errors_ = 0;
    registration_ = Registration::kReregistered;
    late = "re-registration took until the deadline of the decision";
  }

  if (!has_time()) {
    reply = failed_reply(agent_, Rpc::kRegister, {RpcOutcome::kDeadline, 0, late});
    return true;
  }
  begin_call(playmaker);
  return false;
}

bool PlaymakerClient::handle_decision_reply(Playmaker& playmaker, const Reply& reply) {
  switch (reply.status.outcome) {
    case RpcOutcome::kOk:
      if (registration_ == Registration::kReregistered) ++reconnects_;
      registration_ = Registration::kRegistered;
      errors_ = 0;
      max_errors_ = kMaxErrors;
      return true;

    case RpcOutcome::kUnavailable: {
      reregister(0);
      const bool lost = playmaker.take_connection_loss(agent_);
      if (!lost || std::exchange(retried_, true) || !has_time()) return true;
      note_connection_loss();
      if (!limits_.server_waits) return true;  // it cannot reconnect within this cycle
      begin_handshake_call(playmaker);
      return false;
    }

    case RpcOutcome::kError:
      if (++errors_ < max_errors_) return true;
      max_errors_ *= 2;
      reregister(errors_);
      return true;

    default:
      return true;
  }
}

}  // namespace cls::proxy
