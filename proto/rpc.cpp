// Names and messages of the rpcs.
#include "proto/rpc.h"

#include <algorithm>

#include "proto/playmaker.pb.h"

namespace cls::proto {
namespace {

Caller caller_from(const protos::RegisterResponse& identity) {
  return {identity.team_name(), identity.uniform_number(), identity.client_id()};
}

template <typename Request>
Caller introduced(const google::protobuf::Message& request) {
  return caller_from(static_cast<const Request&>(request).register_response());
}

}  // namespace

const std::vector<std::string_view>& rpc_names() {
  static const std::vector<std::string_view> names = {
      "Register",        "SendServerParams",  "SendPlayerParams",
      "SendPlayerType",  "SendInitMessage",   "GetPlayerActions",
      "GetCoachActions", "GetTrainerActions", "GetBestPlannerAction",
      "SendByeCommand"};
  return names;
}

std::string_view name(Rpc rpc) { return rpc_names().at(static_cast<std::size_t>(rpc)); }

std::optional<Rpc> rpc_from_name(std::string_view name) {
  const auto& names = rpc_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Rpc>(found - names.begin());
}

const google::protobuf::Message& request_prototype(Rpc rpc) {
  switch (rpc) {
    case Rpc::kRegister:
      return protos::RegisterRequest::default_instance();
    case Rpc::kSendServerParams:
      return protos::ServerParam::default_instance();
    case Rpc::kSendPlayerParams:
      return protos::PlayerParam::default_instance();
    case Rpc::kSendPlayerType:
      return protos::PlayerType::default_instance();
    case Rpc::kSendInitMessage:
      return protos::InitMessage::default_instance();
    case Rpc::kGetBestPlannerAction:
      return protos::BestPlannerActionRequest::default_instance();
    case Rpc::kSendByeCommand:
      return protos::RegisterResponse::default_instance();
    case Rpc::kGetPlayerActions:
    case Rpc::kGetCoachActions:
    case Rpc::kGetTrainerActions:
      break;
  }
  return protos::State::default_instance();
}

const google::protobuf::Message& reply_prototype(Rpc rpc) {
  switch (rpc) {
    case Rpc::kRegister:
      return protos::RegisterResponse::default_instance();
    case Rpc::kGetPlayerActions:
      return protos::PlayerActions::default_instance();
    case Rpc::kGetCoachActions:
      return protos::CoachActions::default_instance();
    case Rpc::kGetTrainerActions:
      return protos::TrainerActions::default_instance();
    case Rpc::kGetBestPlannerAction:
      return protos::BestPlannerActionResponse::default_instance();
    default:
      return protos::Empty::default_instance();
  }
}

Caller caller_of(Rpc rpc, const google::protobuf::Message& request) {
  switch (rpc) {
    case Rpc::kRegister: {
      const auto& introduction = static_cast<const protos::RegisterRequest&>(request);
      return {introduction.team_name(), introduction.uniform_number(), 0};
    }
    case Rpc::kSendServerParams:
      return introduced<protos::ServerParam>(request);
    case Rpc::kSendPlayerParams:
      return introduced<protos::PlayerParam>(request);
    case Rpc::kSendPlayerType:
      return introduced<protos::PlayerType>(request);
    case Rpc::kSendInitMessage:
      return introduced<protos::InitMessage>(request);
    case Rpc::kGetBestPlannerAction:
      return introduced<protos::BestPlannerActionRequest>(request);
    case Rpc::kSendByeCommand:
      return caller_from(static_cast<const protos::RegisterResponse&>(request));
    case Rpc::kGetPlayerActions:
    case Rpc::kGetCoachActions:
    case Rpc::kGetTrainerActions:
      break;
  }
  const auto& state = static_cast<const protos::State&>(request);
  Caller caller = caller_from(state.register_response());
  if (caller.unum == 0) caller.unum = state.world_model().self().uniform_number();
  return caller;
}

}  // namespace cls::proto
