// Taking a call of the team apart, and collecting the replies to its agents.
#include "mock-server/service/team_responder.h"

#include <algorithm>
#include <utility>

#include "proto/lean_state.h"
#include "proto/playmaker.pb.h"
#include "proto/team_playmaker.pb.h"

namespace cls::mock_server {
namespace {

namespace wire = cls::playmaker::v1;
using google::protobuf::Message;
using proto::Rpc;

// The calls of single agents in one call of the team, one after the other.
class TeamCall {
 public:
  TeamCall(Responder& responder, Workspace& workspace)
      : responder_(responder), workspace_(workspace) {}

  // The agent's reply, unless the agent gets none.
  template <typename Replies>
  void respond(const wire::AgentMessage& call, Rpc rpc, Replies& replies) {
    Message& request = workspace_.create(request_prototype(rpc));
    Message& message = workspace_.create(reply_prototype(rpc));
    Response one;

    if (request.ParseFromString(call.message())) {
      if (is_decision(rpc)) proto::complete(static_cast<protos::State&>(request));
      one = responder_.respond(rpc, request, message);
    } else {
      one.status = {grpc::StatusCode::INTERNAL, "the request does not parse"};
    }

    response_.delay_ms = std::max(response_.delay_ms, one.delay_ms);
    if (one.status.error_code() == grpc::StatusCode::UNAVAILABLE) response_.status = one.status;
    ++calls_;

    if (one.hangs) {
      ++hanging_;
      return;
    }

    wire::AgentReply& reply = *replies.Add();
    reply.set_agent(call.agent());
    if (!one.status.ok()) {
      reply.set_code(one.status.error_code());
      reply.set_error(one.status.error_message());
    } else if (one.bytes) {
      reply.set_message(std::move(*one.bytes));
    } else {
      message.SerializeToString(reply.mutable_message());
    }
  }

  // The rest of an agent's handshake.
  void introduce(const protos::RegisterResponse& identity, Rpc rpc, const std::string& bytes) {
    Message& request = workspace_.create(request_prototype(rpc));
    if (!request.ParseFromString(bytes)) return;
    set_identity(rpc, identity, request);
    responder_.respond(rpc, request, workspace_.create(reply_prototype(rpc)));
  }

  bool lean_states() const { return responder_.lean_states(); }

  // How the call of the team ends. It hangs when every agent's call does.
  Response result() const {
    Response response = response_;
    response.hangs = calls_ != 0 && hanging_ == calls_;
    return response;
  }

 private:
  Responder& responder_;
  Workspace& workspace_;
  Response response_;
  int calls_ = 0;
  int hanging_ = 0;
};

void register_team(TeamCall& call, const wire::RegisterTeamRequest& request,
                   wire::RegisterTeamResponse& response) {
  response.set_version(proto::kTeamPlaymakerVersion);

  const auto& offered = request.encodings();
  const bool lean_offered = std::ranges::find(offered, wire::LEAN_STATES) != offered.end();
  if (call.lean_states() && lean_offered) {
    response.set_encoding(wire::LEAN_STATES);
  }

  for (const wire::AgentMessage& agent : request.agents()) {
    call.respond(agent, Rpc::kRegister, *response.mutable_agents());
  }

  for (const wire::AgentReply& agent : response.agents()) {
    protos::RegisterResponse identity;
    if (agent.code() != 0 || !identity.ParseFromString(agent.message())) continue;
    call.introduce(identity, Rpc::kSendServerParams, request.server_params());
    call.introduce(identity, Rpc::kSendPlayerParams, request.player_params());
    for (const std::string& type : request.player_types()) {
      call.introduce(identity, Rpc::kSendPlayerType, type);
    }
    call.introduce(identity, Rpc::kSendInitMessage, request.init_message());
  }
}

void respond(TeamCall& call, Rpc rpc, const Message& request, Message& response) {
  // Each agent's call, of the RPC that `rpc_of` names.
  const auto respond_to = [&call](const auto& agents, auto rpc_of, auto& replies) {
    for (const auto& agent : agents) call.respond(agent, rpc_of(agent.agent()), replies);
  };

  if (rpc == Rpc::kRegisterTeam) {
    register_team(call, static_cast<const wire::RegisterTeamRequest&>(request),
                  static_cast<wire::RegisterTeamResponse&>(response));
  } else if (rpc == Rpc::kGetTeamActions) {
    respond_to(static_cast<const wire::GetTeamActionsRequest&>(request).agents(),
               proto::decision_of,
               *static_cast<wire::GetTeamActionsResponse&>(response).mutable_agents());
  } else if (rpc == Rpc::kGetBestPlannerActions) {
    respond_to(
        static_cast<const wire::GetBestPlannerActionsRequest&>(request).agents(),
        [](int) { return Rpc::kGetBestPlannerAction; },
        *static_cast<wire::GetBestPlannerActionsResponse&>(response).mutable_agents());
  } else {
    google::protobuf::RepeatedPtrField<wire::AgentReply> none;
    respond_to(
        static_cast<const wire::UnregisterTeamRequest&>(request).agents(),
        [](int) { return Rpc::kSendByeCommand; }, none);
  }
}

}  // namespace

Response respond_to_team(Responder& responder, Rpc rpc, const Message& request, Message& reply,
                         Workspace& workspace) {
  if (responder.older_interface()) {
    Response response;
    response.status = {grpc::StatusCode::UNIMPLEMENTED, "injected fault: no TeamPlaymaker"};
    return response;
  }
  TeamCall call(responder, workspace);
  respond(call, rpc, request, reply);
  return call.result();
}

}  // namespace cls::mock_server
