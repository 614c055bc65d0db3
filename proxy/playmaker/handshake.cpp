// Requests of the handshake, built one at a time.
#include "proxy/playmaker/handshake.h"

#include <utility>

#include "proxy/messages/parameter_messages.h"

namespace cls::proxy {
namespace {

using proto::Rpc;

constexpr std::size_t kFirstType = 3;  // position of the first SendPlayerType

// The identity for Playmakers of the first interface, which assign none.
protos::RegisterResponse identity_from(const protos::RegisterRequest& request) {
  protos::RegisterResponse identity;
  identity.set_agent_type(request.agent_type());
  identity.set_team_name(request.team_name());
  identity.set_uniform_number(request.uniform_number());
  return identity;
}

}  // namespace

Handshake::Handshake(protos::RegisterRequest registration,
                     std::shared_ptr<const player::MatchParameters> parameters)
    : registration_(std::move(registration)), parameters_(std::move(parameters)) {
  make_request();
}

Rpc Handshake::rpc() const {
  if (position_ == 0) return Rpc::kRegister;
  if (position_ == 1) return Rpc::kSendServerParams;
  if (position_ == 2) return Rpc::kSendPlayerParams;
  return position_ < kFirstType + parameters_->types.size() ? Rpc::kSendPlayerType
                                                            : Rpc::kSendInitMessage;
}

void Handshake::make_request() {
  request_.reset(request_prototype(rpc()).New());

  switch (rpc()) {
    case Rpc::kRegister:
      request_->CopyFrom(registration_);
      break;
    case Rpc::kSendServerParams:
      fill(parameters_->server, static_cast<protos::ServerParam&>(*request_));
      break;
    case Rpc::kSendPlayerParams:
      fill(parameters_->player, static_cast<protos::PlayerParam&>(*request_));
      break;
    case Rpc::kSendPlayerType:
      fill(parameters_->types[position_ - kFirstType], parameters_->server,
           static_cast<protos::PlayerType&>(*request_));
      break;
    default:
      break;
  }

  set_identity(rpc(), identity_, *request_);
}

Handshake::Next Handshake::handle_reply(const Reply& reply) {
  const RpcOutcome outcome = reply.status.outcome;
  warning_.clear();

  if (position_ == 0 && outcome == RpcOutcome::kUnimplemented) {
    identity_ = identity_from(registration_);
    warning_ = "the Playmaker does not implement Register; using the first interface";
  } else if (position_ == 0) {
    const auto* identity = reply.as<protos::RegisterResponse>();
    if (identity == nullptr) return Next::kFailed;
    identity_ = *identity;
  } else if (outcome == RpcOutcome::kUnimplemented || outcome == RpcOutcome::kError) {
    warning_ = reply.status.message;
  } else if (!reply.status.ok()) {
    return Next::kFailed;
  }

  if (++position_ == calls()) return Next::kComplete;
  make_request();
  return Next::kCall;
}

}  // namespace cls::proxy
