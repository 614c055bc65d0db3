// A Playmaker in memory; tests define replies, failures and the order of replies.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "proxy/playmaker/playmaker.h"

namespace cls::tests {

/// Records every call. `decide` makes the decisions; `order` selects the next reply.
class FakePlaymaker : public proxy::Playmaker {
 public:
  /// Fills the reply for an agent's State; a status that is not ok fails the call.
  std::function<proxy::RpcStatus(int agent, const protos::State&, protos::PlayerActions&)> decide;
  /// Index of the outstanding agent that replies next; default: the first.
  std::function<std::size_t(const std::vector<int>& outstanding)> order;
  /// Status of a handshake call; default: ok.
  std::function<proxy::RpcStatus(const std::string& method, int agent)> handshake_status;
  /// Fails the handshake calls of this method; with `only`, of that agent.
  void fail(const std::string& method, const proxy::RpcStatus& status, int only = 0) {
    handshake_status = [=](const std::string& called, int agent) {
      return called == method && (only == 0 || agent == only) ? status : proxy::RpcStatus{};
    };
  }
  /// Agents with a connection loss not yet taken.
  std::set<int> lost;
  /// client_id from Register: 100 + agent, plus 1000 for each re-registration.
  int client_id(int agent) const { return 100 + agent + 1000 * (registered_.at(agent) - 1); }

  /// "METHOD AGENT" of every call, in order.
  const std::vector<std::string>& calls() const { return calls_; }
  std::size_t max_outstanding() const { return max_outstanding_; }

  void begin(int agent, proto::Rpc rpc, const google::protobuf::Message& request,
             proxy::RpcTimeout timeout, bool wait_for_ready) override;
  proxy::Reply call(int agent, proto::Rpc rpc, const google::protobuf::Message& request,
                    proxy::RpcTimeout timeout) override;
  bool take_connection_loss(int agent) override { return lost.erase(agent) > 0; }
  std::optional<proxy::Reply> next_reply() override;
  std::optional<proxy::Reply> next_reply_within(std::chrono::microseconds) override {
    return next_reply();
  }
  void cancel() override {}

 private:
  proxy::Reply handshake_reply(int agent, proto::Rpc rpc, const google::protobuf::Message& request);

  std::vector<std::string> calls_;
  std::vector<int> outstanding_;
  std::size_t max_outstanding_ = 0;
  std::map<int, std::optional<proxy::Reply>> handshakes_;  // to the call in flight
  std::map<int, protos::RegisterResponse> identities_;
  std::map<int, int> registered_;  // times
  std::map<int, protos::State> states_;
  std::map<int, protos::PlayerActions> replies_;
};

}  // namespace cls::tests
