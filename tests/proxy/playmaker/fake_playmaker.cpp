// Replies of the fake Playmaker.
#include "tests/proxy/playmaker/fake_playmaker.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace cls::tests {

using google::protobuf::Message;
using proto::Rpc;
using proxy::Reply;
using proxy::RpcTimeout;

Reply FakePlaymaker::handshake_reply(int agent, Rpc rpc, const Message& request) {
  const std::string method(name(rpc));
  calls_.push_back(method + " " + std::to_string(agent));
  Reply reply;
  reply.agent = agent;
  reply.rpc = rpc;
  if (handshake_status) reply.status = handshake_status(method, agent);
  if (!reply.status.ok()) return reply;
  reply.message = &reply_prototype(rpc);

  if (rpc == Rpc::kRegister) {
    const auto& registration = static_cast<const protos::RegisterRequest&>(request);
    protos::RegisterResponse& identity = identities_[agent];
    ++registered_[agent];
    identity.set_client_id(client_id(agent));
    identity.set_team_name(registration.team_name());
    identity.set_uniform_number(registration.uniform_number());
    reply.message = &identity;
  }

  return reply;
}

Reply FakePlaymaker::call(int agent, Rpc rpc, const Message& request, RpcTimeout) {
  return handshake_reply(agent, rpc, request);
}

void FakePlaymaker::begin(int agent, Rpc rpc, const Message& request, RpcTimeout, bool) {
  if (rpc == Rpc::kGetPlayerActions) {
    calls_.push_back("GetPlayerActions " + std::to_string(agent));
    states_[agent].CopyFrom(request);
  } else if (is_decision(rpc) || rpc == Rpc::kGetBestPlannerAction) {
    throw std::logic_error("no test calls " + std::string(name(rpc)));
  } else {
    handshakes_[agent] = handshake_reply(agent, rpc, request);
  }
  outstanding_.push_back(agent);
  max_outstanding_ = std::max(max_outstanding_, outstanding_.size());
}

std::optional<Reply> FakePlaymaker::next_reply() {
  if (outstanding_.empty()) return std::nullopt;
  const std::size_t chosen = order ? order(outstanding_) : 0;
  const auto position = outstanding_.begin() + static_cast<std::ptrdiff_t>(chosen);
  Reply reply;
  reply.agent = *position;
  reply.rpc = Rpc::kGetPlayerActions;
  outstanding_.erase(position);
  if (auto& handshake = handshakes_[reply.agent]) return std::exchange(handshake, std::nullopt);
  protos::PlayerActions& actions = replies_[reply.agent];
  actions.Clear();
  if (decide) reply.status = decide(reply.agent, states_[reply.agent], actions);
  if (reply.status.ok()) reply.message = &actions;
  reply.latency = std::chrono::microseconds(10 * reply.agent);
  return reply;
}

}  // namespace cls::tests
