// A Playmaker in memory, whose answers, failures and order of replies a test chooses.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "proxy/playmaker/playmaker.h"

namespace cls::tests {

/// Notes every call. Decisions are answered by `decide`, in the order that `order` gives.
class FakePlaymaker : public proxy::Playmaker {
 public:
  /// Fills the answer for an agent's State; a status that is not ok is the answer's failure.
  std::function<proxy::RpcStatus(int agent, const protos::State&, protos::PlayerActions&)> decide;
  /// Which of the outstanding agents answers next; default: the one asked first.
  std::function<std::size_t(const std::vector<int>& outstanding)> order;
  /// Status of a hand-shake call; default: ok.
  std::function<proxy::RpcStatus(const std::string& method, int agent)> answer;
  /// Agents whose connection is gone, until they are told.
  std::set<int> lost;
  /// What Register gives: 100 + agent, with 1000 more each time.
  int client_id(int agent) const { return 100 + agent + 1000 * (registered_.at(agent) - 1); }

  /// "METHOD AGENT" of every call, in order.
  const std::vector<std::string>& calls() const { return calls_; }
  std::size_t most_outstanding() const { return most_outstanding_; }

  proxy::RpcStatus register_agent(int agent, const protos::RegisterRequest& request,
                                  proxy::RpcTimeout timeout,
                                  protos::RegisterResponse& response) override;
  proxy::RpcStatus send_server_params(int agent, const protos::ServerParam& params,
                                      proxy::RpcTimeout timeout) override;
  proxy::RpcStatus send_player_params(int agent, const protos::PlayerParam& params,
                                      proxy::RpcTimeout timeout) override;
  proxy::RpcStatus send_player_type(int agent, const protos::PlayerType& type,
                                    proxy::RpcTimeout timeout) override;
  proxy::RpcStatus send_init_message(int agent, const protos::InitMessage& message,
                                     proxy::RpcTimeout timeout) override;
  proxy::RpcStatus send_bye(int agent, const protos::RegisterResponse& identity,
                            proxy::RpcTimeout timeout) override;
  void begin_player_actions(int agent, const protos::State& state,
                            proxy::RpcTimeout timeout) override;
  void begin_coach_actions(int agent, const protos::State& state,
                           proxy::RpcTimeout timeout) override;
  void begin_trainer_actions(int agent, const protos::State& state,
                             proxy::RpcTimeout timeout) override;
  void begin_best_planner_action(int agent, const protos::BestPlannerActionRequest& request,
                                 proxy::RpcTimeout timeout) override;
  void begin_introduction(int agent, proto::Rpc rpc, const google::protobuf::Message& request,
                          proxy::RpcTimeout timeout, bool wait) override;
  bool take_lost_connection(int agent) override { return lost.erase(agent) > 0; }
  std::optional<proxy::Reply> next_reply() override;
  std::optional<proxy::Reply> next_reply_within(std::chrono::microseconds) override {
    return next_reply();
  }
  void cancel() override {}

 private:
  proxy::RpcStatus note(const std::string& method, int agent);
  proxy::RpcStatus let_in(int agent, const protos::RegisterRequest& request,
                          protos::RegisterResponse& response);

  std::vector<std::string> calls_;
  std::vector<int> outstanding_;
  std::size_t most_outstanding_ = 0;
  std::map<int, std::optional<proxy::RpcStatus>> introductions_;  // status of the call in flight
  std::map<int, protos::RegisterResponse> identities_;
  std::map<int, int> registered_;  // times
  std::map<int, protos::State> states_;
  std::map<int, protos::PlayerActions> replies_;
};

}  // namespace cls::tests
