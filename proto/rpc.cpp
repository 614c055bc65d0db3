// Names and message types of the RPCs, from the descriptors of the services.
#include "proto/rpc.h"

#include <cassert>

#include "proto/playmaker.pb.h"
#include "proto/team_playmaker.pb.h"

namespace cls::proto {
namespace {

using google::protobuf::Message;

struct RpcDescription {
  std::string path;
  std::string_view name;
  const Message* request = nullptr;
  const Message* reply = nullptr;
  /// The sender's identity in the request; null where the request has no such field.
  const google::protobuf::FieldDescriptor* identity = nullptr;
};

RpcDescription describe(const google::protobuf::MethodDescriptor& method) {
  auto* messages = google::protobuf::MessageFactory::generated_factory();
  RpcDescription description;
  description.path = "/" + method.service()->full_name() + "/" + method.name();
  description.name = method.name();
  description.request = messages->GetPrototype(method.input_type());
  description.reply = messages->GetPrototype(method.output_type());
  description.identity = method.input_type()->FindFieldByName("register_response");
  return description;
}

const RpcDescription& describe(Rpc rpc) {
  static const auto descriptions = [] {
    const auto* game = protos::State::descriptor()->file()->FindServiceByName("Game");
    const auto* team =
        playmaker::v1::AgentReply::descriptor()->file()->FindServiceByName("TeamPlaymaker");
    assert(game != nullptr && game->method_count() == kAgentRpcs);
    assert(team != nullptr && team->method_count() == kRpcs - kAgentRpcs);

    std::vector<RpcDescription> all;
    for (int i = 0; i < kAgentRpcs; ++i) all.push_back(describe(*game->method(i)));
    for (int i = 0; i < kRpcs - kAgentRpcs; ++i) all.push_back(describe(*team->method(i)));
    return all;
  }();
  return descriptions.at(static_cast<std::size_t>(rpc));
}

const protos::RegisterResponse& identity_in(Rpc rpc, const Message& request) {
  const auto* field = describe(rpc).identity;
  return static_cast<const protos::RegisterResponse&>(
      field == nullptr ? request : request.GetReflection()->GetMessage(request, field));
}

}  // namespace

std::string_view name(Rpc rpc) { return describe(rpc).name; }
const std::string& path(Rpc rpc) { return describe(rpc).path; }

const std::vector<std::string_view>& agent_rpc_names() {
  static const auto names = [] {
    std::vector<std::string_view> all;
    for (int i = 0; i < kAgentRpcs; ++i) all.push_back(name(static_cast<Rpc>(i)));
    return all;
  }();
  return names;
}

std::optional<Rpc> rpc_from_name(std::string_view name) {
  for (int i = 0; i < kRpcs; ++i) {
    if (proto::name(static_cast<Rpc>(i)) == name) return static_cast<Rpc>(i);
  }
  return std::nullopt;
}

const Message& request_prototype(Rpc rpc) { return *describe(rpc).request; }
const Message& reply_prototype(Rpc rpc) { return *describe(rpc).reply; }

Caller caller_of(Rpc rpc, const Message& request) {
  if (rpc == Rpc::kRegister) {
    const auto& registration = static_cast<const protos::RegisterRequest&>(request);
    return {registration.team_name(), registration.uniform_number(), 0};
  }

  const protos::RegisterResponse& identity = identity_in(rpc, request);
  Caller caller{identity.team_name(), identity.uniform_number(), identity.client_id()};
  if (is_decision(rpc) && caller.unum == 0) {
    caller.unum = static_cast<const protos::State&>(request).world_model().self().uniform_number();
  }
  return caller;
}

void set_identity(Rpc rpc, const protos::RegisterResponse& identity, Message& request) {
  if (rpc == Rpc::kRegister) return;
  const auto* field = describe(rpc).identity;
  Message& target =
      field == nullptr ? request : *request.GetReflection()->MutableMessage(&request, field);
  target.CopyFrom(identity);
}

}  // namespace cls::proto
