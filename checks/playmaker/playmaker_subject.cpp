// Calls to a Playmaker under test.
#include "checks/playmaker/playmaker_subject.h"

#include <fmt/format.h>

#include <utility>

#include "base/index.h"
#include "checks/playmaker/sample_states.h"
#include "proxy/messages/parameter_messages.h"
#include "soccer/parameters/player_type.h"

namespace cls::checks {
namespace {

using proto::Rpc;

constexpr int kSeed = 1;

protos::AgentType type_of(int agent) {
  if (agent == proxy::kCoachNumber) return protos::CoachT;
  return agent == proxy::kTrainerNumber ? protos::TrainerT : protos::PlayerT;
}

const std::shared_ptr<const player::MatchParameters>& parameters() {
  static const auto kParameters = [] {
    auto made = std::make_shared<player::MatchParameters>();
    made->types = soccer::draw_player_types(made->server, made->player, kSeed);
    return std::shared_ptr<const player::MatchParameters>(std::move(made));
  }();
  return kParameters;
}

}  // namespace

std::string team_name(int team) { return team == 0 ? "Check_L" : "Check_R"; }

protos::State PlaymakerSubject::next_state(int agent) {
  return ordinary_state(identity(agent), ++cycle);
}

protos::RegisterRequest registration_request(int team, int agent) {
  protos::RegisterRequest request;
  request.set_agent_type(type_of(agent));
  request.set_team_name(team_name(team));
  request.set_uniform_number(agent);
  request.set_rpc_version(1);
  return request;
}

proxy::TeamRegistration registration_of_team(int team) {
  proxy::TeamRegistration registration;
  for (int agent = 1; agent <= proxy::kCoachNumber; ++agent) {
    registration.agents.emplace_back(agent, registration_request(team, agent));
  }
  registration.parameters = parameters();
  return registration;
}

proxy::RpcStatus register_agent(PlaymakerSubject& subject, int team, int agent) {
  const auto t = base::index(team);
  const proxy::Reply reply = subject.teams[t]->call(
      agent, Rpc::kRegister, registration_request(team, agent), subject.start_timeout);
  if (const auto* identity = reply.as<protos::RegisterResponse>()) {
    subject.identities[t][base::index(agent)] = *identity;
  }
  return reply.status;
}

proxy::RpcStatus send_parameters(PlaymakerSubject& subject, int team, int agent) {
  const auto t = base::index(team);
  proxy::Playmaker& playmaker = *subject.teams[t];
  const protos::RegisterResponse& identity = subject.identities[t][base::index(agent)];
  const player::MatchParameters& known = *parameters();

  protos::ServerParam server_message;
  proxy::fill(known.server, server_message);
  *server_message.mutable_register_response() = identity;

  const auto send = [&](Rpc rpc, const google::protobuf::Message& message) {
    return playmaker.call(agent, rpc, message, subject.deadline).status;
  };
  auto status = send(Rpc::kSendServerParams, server_message);
  if (!status.ok()) return status;

  protos::PlayerParam player_message;
  proxy::fill(known.player, player_message);
  *player_message.mutable_register_response() = identity;
  status = send(Rpc::kSendPlayerParams, player_message);

  for (const soccer::PlayerType& type : known.types) {
    if (!status.ok()) return status;
    protos::PlayerType message;
    proxy::fill(type, known.server, message);
    *message.mutable_register_response() = identity;
    status = send(Rpc::kSendPlayerType, message);
  }
  return status;
}

proxy::RpcStatus complete_handshake(PlaymakerSubject& subject, int team) {
  proxy::RpcStatus status;
  for (int agent = 1; agent <= proxy::kCoachNumber && status.ok(); ++agent) {
    status = register_agent(subject, team, agent);
    if (status.ok()) status = send_parameters(subject, team, agent);
    if (!status.ok()) return status;

    const auto t = base::index(team);
    protos::InitMessage message;
    *message.mutable_register_response() = subject.identities[t][base::index(agent)];
    status = subject.teams[t]->call(agent, Rpc::kSendInitMessage, message, subject.deadline).status;
  }
  return status;
}

Answer ask(proxy::Playmaker& playmaker, int agent, const protos::State& state,
           Milliseconds deadline) {
  const proxy::Reply reply = playmaker.call(agent, Rpc::kGetPlayerActions, state, deadline);
  Answer answer;
  answer.status = reply.status;
  answer.latency = reply.latency;
  if (const auto* actions = reply.as<protos::PlayerActions>()) answer.actions = *actions;
  return answer;
}

proxy::RpcStatus call(PlaymakerSubject& subject, int agent, Rpc rpc,
                      const google::protobuf::Message& request) {
  return subject.left().call(agent, rpc, request, subject.deadline).status;
}

Answer ask(PlaymakerSubject& subject, int agent, const protos::State& state) {
  return ask(subject.left(), agent, state, subject.deadline);
}

std::string to_text(const proxy::RpcStatus& status) {
  if (status.ok()) return "ok";
  return fmt::format("{} (gRPC status {}): {}", name(status.outcome), status.code, status.message);
}

Finding finding(const proxy::RpcStatus& status, std::string evidence) {
  if (!status.ok()) return fail(to_text(status));
  return pass(evidence.empty() ? "answered" : std::move(evidence));
}

Finding survives(PlaymakerSubject& subject, const std::string& before) {
  const Answer answer = ask(subject, kAgent, subject.next_state(kAgent));
  if (answer.status.ok()) return pass(before + "; replies to the next ordinary request");
  return fail(before + "; then an ordinary request: " + to_text(answer.status));
}

}  // namespace cls::checks
