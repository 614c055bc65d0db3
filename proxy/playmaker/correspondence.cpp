// Which call comes next, and what a failed one means.
#include "proxy/playmaker/correspondence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace cls::proxy {
namespace {

using proto::Rpc;

constexpr int kErrorsBorne = 3;
constexpr RpcTimeout kShortest{1};
// In real time a Playmaker may take longer over Register than a cycle lasts; the cycles that pass
// meanwhile are lost, as they are when it is first met.
constexpr RpcTimeout kRegisterTime{1000};

void add_once(std::string& remarks, const std::string& remark) {
  if (remarks.find(remark) != std::string::npos) return;
  if (!remarks.empty()) remarks += "; ";
  remarks += remark;
}

RpcStatus call(Playmaker& playmaker, int agent, const Introduction& step, RpcTimeout timeout,
               protos::RegisterResponse& identity) {
  const google::protobuf::Message& request = step.request();
  switch (step.rpc()) {
    case Rpc::kRegister:
      return playmaker.register_agent(agent, static_cast<const protos::RegisterRequest&>(request),
                                      timeout, identity);
    case Rpc::kSendServerParams:
      return playmaker.send_server_params(agent, static_cast<const protos::ServerParam&>(request),
                                          timeout);
    case Rpc::kSendPlayerParams:
      return playmaker.send_player_params(agent, static_cast<const protos::PlayerParam&>(request),
                                          timeout);
    case Rpc::kSendPlayerType:
      return playmaker.send_player_type(agent, static_cast<const protos::PlayerType&>(request),
                                        timeout);
    default:
      return playmaker.send_init_message(agent, static_cast<const protos::InitMessage&>(request),
                                         timeout);
  }
}

}  // namespace

Correspondence::Correspondence(int agent, Rpc decision, protos::RegisterRequest who,
                               std::shared_ptr<const MatchParameters> parameters)
    : agent_(agent),
      decision_(decision),
      who_(std::move(who)),
      parameters_(std::move(parameters)),
      errors_borne_(kErrorsBorne) {
  assert(is_decision(decision));
}

RpcStatus Correspondence::introduce(Playmaker& playmaker, RpcTimeout timeout,
                                    protos::State& state) {
  Introduction introduction(who_, parameters_);
  for (;;) {
    protos::RegisterResponse identity;
    const RpcStatus status = call(playmaker, agent_, introduction, timeout, identity);
    const Introduction::Next next = introduction.take(status, &identity);
    if (next == Introduction::Next::kFailed) return status;
    add_once(remark_, introduction.remark());
    *state.mutable_register_response() = introduction.identity();
    if (next == Introduction::Next::kDone) return {};
  }
}

RpcTimeout Correspondence::time_left() const {
  if (time_.timeout == kNoTimeout) return kNoTimeout;
  return std::max(kShortest, std::chrono::ceil<RpcTimeout>(until_ - Clock::now()));
}

void Correspondence::meet_anew() { introduction_.emplace(who_, parameters_); }

void Correspondence::ask(Playmaker& playmaker, protos::State& state, const AskingTime& time) {
  state_ = &state;
  time_ = time;
  asked_again_ = false;
  if (time.timeout != kNoTimeout) until_ = Clock::now() + time.timeout;
  if (playmaker.take_lost_connection(agent_)) {
    if (!lost_since_) lost_since_ = Clock::now();
    meet_anew();
  }
  if (introduction_) {
    begin_introduction_call(playmaker);
  } else {
    begin_decision(playmaker);
  }
}

void Correspondence::begin_decision(Playmaker& playmaker) {
  in_introduction_ = false;
  switch (decision_) {
    case Rpc::kGetCoachActions:
      playmaker.begin_coach_actions(agent_, *state_, time_left());
      break;
    case Rpc::kGetTrainerActions:
      playmaker.begin_trainer_actions(agent_, *state_, time_left());
      break;
    default:
      playmaker.begin_player_actions(agent_, *state_, time_left());
  }
}

void Correspondence::begin_introduction_call(Playmaker& playmaker) {
  in_introduction_ = true;
  RpcTimeout timeout = time_left();
  bool wait = false;
  if (introduction_->rpc() == Rpc::kRegister) {
    if (!time_.server_waits) timeout = std::max(timeout, kRegisterTime);
    if (time_.server_waits && lost_since_) {
      const auto gone = std::chrono::duration_cast<RpcTimeout>(Clock::now() - *lost_since_);
      wait = gone < time_.reconnect_within;
      if (wait) timeout = std::min(timeout, time_.reconnect_within - gone);
    }
  }
  playmaker.begin_introduction(agent_, introduction_->rpc(), introduction_->request(), timeout,
                               wait);
}

bool Correspondence::take(Playmaker& playmaker, Reply& reply) {
  assert(reply.agent == agent_);
  return in_introduction_ ? take_introduction(playmaker, reply) : take_decision(playmaker, reply);
}

bool Correspondence::take_introduction(Playmaker& playmaker, Reply& reply) {
  const Introduction::Next next = introduction_->take(reply.status, reply.identity);
  add_once(remark_, introduction_->remark());
  if (next == Introduction::Next::kFailed) {
    // A slow Playmaker is told the rest in the next cycles; any other is met from the beginning.
    if (reply.status.outcome != RpcOutcome::kDeadline) meet_anew();
    return true;
  }
  *state_->mutable_register_response() = introduction_->identity();
  if (next == Introduction::Next::kDone) {
    introduction_.reset();
    lost_since_.reset();
    errors_ = 0;
    met_anew_ = true;
  }
  if (!has_time()) {
    reply = Reply{};
    reply.agent = agent_;
    reply.status = {RpcOutcome::kDeadline, 0,
                    introduction_ ? fmt::format("{} of {} calls to make the agent known again fit "
                                                "into the time of a decision",
                                                introduction_->answered(), introduction_->calls())
                                  : "making the agent known again took the time of a decision"};
    return true;
  }
  if (introduction_) {
    begin_introduction_call(playmaker);
  } else {
    begin_decision(playmaker);
  }
  return false;
}

bool Correspondence::take_decision(Playmaker& playmaker, const Reply& reply) {
  switch (reply.status.outcome) {
    case RpcOutcome::kOk:
      if (std::exchange(met_anew_, false)) ++reconnects_;
      errors_ = 0;
      errors_borne_ = kErrorsBorne;
      return true;
    case RpcOutcome::kUnavailable: {
      meet_anew();
      const bool lost = playmaker.take_lost_connection(agent_);
      if (!lost || std::exchange(asked_again_, true) || !has_time()) return true;
      if (!lost_since_) lost_since_ = Clock::now();
      if (!time_.server_waits) return true;  // it cannot be back within this cycle
      begin_introduction_call(playmaker);
      return false;
    }
    case RpcOutcome::kError:
      if (++errors_ < errors_borne_) return true;
      errors_borne_ *= 2;
      meet_anew();
      return true;
    default:
      return true;
  }
}

}  // namespace cls::proxy
