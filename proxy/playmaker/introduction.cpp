// Requests of the hand-shake, made one at a time.
#include "proxy/playmaker/introduction.h"

#include <utility>

#include "proxy/messages/parameter_messages.h"

namespace cls::proxy {
namespace {

using proto::Rpc;

constexpr std::size_t kFirstType = 3;  // position of the first SendPlayerType

// Calls that inform a Playmaker may fail without harm, as long as it is there and speaks at all.
bool harmless(const RpcStatus& status) {
  return status.outcome == RpcOutcome::kUnimplemented || status.outcome == RpcOutcome::kError;
}

// For Playmakers of the first interface, which do not hand out identities.
protos::RegisterResponse own_identity(const protos::RegisterRequest& request) {
  protos::RegisterResponse identity;
  identity.set_agent_type(request.agent_type());
  identity.set_team_name(request.team_name());
  identity.set_uniform_number(request.uniform_number());
  return identity;
}

template <typename Message>
std::unique_ptr<Message> introduced(const protos::RegisterResponse& identity) {
  auto message = std::make_unique<Message>();
  *message->mutable_register_response() = identity;
  return message;
}

}  // namespace

Introduction::Introduction(protos::RegisterRequest who,
                           std::shared_ptr<const MatchParameters> parameters)
    : who_(std::move(who)), parameters_(std::move(parameters)) {
  make_request();
}

Rpc Introduction::rpc() const {
  if (position_ == 0) return Rpc::kRegister;
  if (position_ == 1) return Rpc::kSendServerParams;
  if (position_ == 2) return Rpc::kSendPlayerParams;
  return position_ < kFirstType + parameters_->types.size() ? Rpc::kSendPlayerType
                                                            : Rpc::kSendInitMessage;
}

void Introduction::make_request() {
  switch (rpc()) {
    case Rpc::kRegister:
      request_ = std::make_unique<protos::RegisterRequest>(who_);
      break;
    case Rpc::kSendServerParams: {
      auto message = introduced<protos::ServerParam>(identity_);
      fill(parameters_->server, *message);
      request_ = std::move(message);
      break;
    }
    case Rpc::kSendPlayerParams: {
      auto message = introduced<protos::PlayerParam>(identity_);
      fill(parameters_->player, *message);
      request_ = std::move(message);
      break;
    }
    case Rpc::kSendPlayerType: {
      auto message = introduced<protos::PlayerType>(identity_);
      fill(parameters_->types[position_ - kFirstType], parameters_->server, *message);
      request_ = std::move(message);
      break;
    }
    default:
      request_ = introduced<protos::InitMessage>(identity_);
  }
}

Introduction::Next Introduction::take(const RpcStatus& status,
                                      const protos::RegisterResponse* identity) {
  remark_.clear();
  if (position_ == 0) {
    if (status.outcome == RpcOutcome::kUnimplemented) {
      identity_ = own_identity(who_);
      remark_ = "the Playmaker has no Register: taken for one of the first interface";
    } else if (!status.ok() || identity == nullptr) {
      return Next::kFailed;
    } else {
      identity_ = *identity;
    }
  } else if (harmless(status)) {
    remark_ = status.message;
  } else if (!status.ok()) {
    return Next::kFailed;
  }
  if (++position_ == calls()) return Next::kDone;
  make_request();
  return Next::kCall;
}

}  // namespace cls::proxy
