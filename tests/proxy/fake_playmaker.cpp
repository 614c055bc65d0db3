// The Playmaker of tests that need no network.
#include "tests/proxy/fake_playmaker.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace cls::tests {

using proxy::RpcStatus;
using proxy::RpcTimeout;

RpcStatus FakePlaymaker::note(const std::string& method, int agent) {
  calls_.push_back(method + " " + std::to_string(agent));
  return answer ? answer(method, agent) : RpcStatus{};
}

RpcStatus FakePlaymaker::let_in(int agent, const protos::RegisterRequest& request,
                                protos::RegisterResponse& response) {
  RpcStatus status = note("Register", agent);
  if (!status.ok()) return status;
  ++registered_[agent];
  response.set_client_id(client_id(agent));
  response.set_team_name(request.team_name());
  response.set_uniform_number(request.uniform_number());
  return status;
}

RpcStatus FakePlaymaker::register_agent(int agent, const protos::RegisterRequest& request,
                                        RpcTimeout, protos::RegisterResponse& response) {
  return let_in(agent, request, response);
}

void FakePlaymaker::begin_introduction(int agent, proto::Rpc rpc,
                                       const google::protobuf::Message& request, RpcTimeout, bool) {
  if (rpc == proto::Rpc::kRegister) {
    introductions_[agent] =
        let_in(agent, static_cast<const protos::RegisterRequest&>(request), identities_[agent]);
  } else {
    introductions_[agent] = note(std::string(proto::name(rpc)), agent);
    identities_.erase(agent);
  }
  outstanding_.push_back(agent);
}

RpcStatus FakePlaymaker::send_server_params(int agent, const protos::ServerParam&, RpcTimeout) {
  return note("SendServerParams", agent);
}
RpcStatus FakePlaymaker::send_player_params(int agent, const protos::PlayerParam&, RpcTimeout) {
  return note("SendPlayerParams", agent);
}
RpcStatus FakePlaymaker::send_player_type(int agent, const protos::PlayerType&, RpcTimeout) {
  return note("SendPlayerType", agent);
}
RpcStatus FakePlaymaker::send_init_message(int agent, const protos::InitMessage&, RpcTimeout) {
  return note("SendInitMessage", agent);
}
RpcStatus FakePlaymaker::send_bye(int agent, const protos::RegisterResponse&, RpcTimeout) {
  return note("SendByeCommand", agent);
}

void FakePlaymaker::begin_player_actions(int agent, const protos::State& state, RpcTimeout) {
  calls_.push_back("GetPlayerActions " + std::to_string(agent));
  outstanding_.push_back(agent);
  most_outstanding_ = std::max(most_outstanding_, outstanding_.size());
  states_[agent] = state;
}

void FakePlaymaker::begin_coach_actions(int, const protos::State&, RpcTimeout) {
  throw std::logic_error("no test asks for a coach's decision");
}
void FakePlaymaker::begin_trainer_actions(int, const protos::State&, RpcTimeout) {
  throw std::logic_error("no test asks for a trainer's decision");
}
void FakePlaymaker::begin_best_planner_action(int, const protos::BestPlannerActionRequest&,
                                              RpcTimeout) {
  throw std::logic_error("no test asks for a planner's decision");
}

std::optional<proxy::Reply> FakePlaymaker::next_reply() {
  if (outstanding_.empty()) return std::nullopt;
  const std::size_t chosen = order ? order(outstanding_) : 0;
  const auto position = outstanding_.begin() + static_cast<std::ptrdiff_t>(chosen);
  proxy::Reply reply;
  reply.agent = *position;
  outstanding_.erase(position);
  if (auto& introduction = introductions_[reply.agent]) {
    reply.status = *std::exchange(introduction, std::nullopt);
    const auto identity = identities_.find(reply.agent);
    if (reply.status.ok() && identity != identities_.end()) reply.identity = &identity->second;
    return reply;
  }
  protos::PlayerActions& actions = replies_[reply.agent];
  actions.Clear();
  if (decide) reply.status = decide(reply.agent, states_[reply.agent], actions);
  if (reply.status.ok()) reply.player = &actions;
  reply.latency = std::chrono::microseconds(10 * reply.agent);
  return reply;
}

}  // namespace cls::tests
