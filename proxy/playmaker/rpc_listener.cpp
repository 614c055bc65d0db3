// A Playmaker that passes everything on and tells of it.
#include "proxy/playmaker/rpc_listener.h"

#include <array>
#include <utility>

namespace cls::proxy {
namespace {

using google::protobuf::Message;
using proto::Rpc;
using Clock = std::chrono::steady_clock;

class ListenedPlaymaker : public Playmaker {
 public:
  ListenedPlaymaker(Playmaker& inner, RpcListener& listener) : inner_(inner), listener_(listener) {}

  RpcStatus register_agent(int agent, const protos::RegisterRequest& request, RpcTimeout timeout,
                           protos::RegisterResponse& response) override {
    const auto start = Clock::now();
    const RpcStatus status = inner_.register_agent(agent, request, timeout, response);
    tell(agent, Rpc::kRegister, request, &response, status, start);
    return status;
  }
  RpcStatus send_server_params(int agent, const protos::ServerParam& params,
                               RpcTimeout timeout) override {
    const auto start = Clock::now();
    return told(agent, Rpc::kSendServerParams, params,
                inner_.send_server_params(agent, params, timeout), start);
  }
  RpcStatus send_player_params(int agent, const protos::PlayerParam& params,
                               RpcTimeout timeout) override {
    const auto start = Clock::now();
    return told(agent, Rpc::kSendPlayerParams, params,
                inner_.send_player_params(agent, params, timeout), start);
  }
  RpcStatus send_player_type(int agent, const protos::PlayerType& type,
                             RpcTimeout timeout) override {
    const auto start = Clock::now();
    return told(agent, Rpc::kSendPlayerType, type, inner_.send_player_type(agent, type, timeout),
                start);
  }
  RpcStatus send_init_message(int agent, const protos::InitMessage& message,
                              RpcTimeout timeout) override {
    const auto start = Clock::now();
    return told(agent, Rpc::kSendInitMessage, message,
                inner_.send_init_message(agent, message, timeout), start);
  }
  RpcStatus send_bye(int agent, const protos::RegisterResponse& identity,
                     RpcTimeout timeout) override {
    const auto start = Clock::now();
    return told(agent, Rpc::kSendByeCommand, identity, inner_.send_bye(agent, identity, timeout),
                start);
  }

  void begin_player_actions(int agent, const protos::State& state, RpcTimeout timeout) override {
    keep(agent, Rpc::kGetPlayerActions, state);
    inner_.begin_player_actions(agent, state, timeout);
  }
  void begin_coach_actions(int agent, const protos::State& state, RpcTimeout timeout) override {
    keep(agent, Rpc::kGetCoachActions, state);
    inner_.begin_coach_actions(agent, state, timeout);
  }
  void begin_trainer_actions(int agent, const protos::State& state, RpcTimeout timeout) override {
    keep(agent, Rpc::kGetTrainerActions, state);
    inner_.begin_trainer_actions(agent, state, timeout);
  }
  void begin_best_planner_action(int agent, const protos::BestPlannerActionRequest& request,
                                 RpcTimeout timeout) override {
    keep(agent, Rpc::kGetBestPlannerAction, request);
    inner_.begin_best_planner_action(agent, request, timeout);
  }

  void begin_introduction(int agent, Rpc rpc, const Message& request, RpcTimeout timeout,
                          bool wait) override {
    keep(agent, rpc, request);
    inner_.begin_introduction(agent, rpc, request, timeout, wait);
  }
  bool take_lost_connection(int agent) override { return inner_.take_lost_connection(agent); }

  std::optional<Reply> next_reply() override { return heard(inner_.next_reply()); }
  std::optional<Reply> next_reply_within(std::chrono::microseconds longest) override {
    return heard(inner_.next_reply_within(longest));
  }
  void cancel() override { inner_.cancel(); }

 private:
  // A question under way; its memory is used again.
  struct Question {
    Rpc rpc = Rpc::kGetPlayerActions;
    std::unique_ptr<Message> request;
  };

  void keep(int agent, Rpc rpc, const Message& request) {
    Question& question = questions_.at(static_cast<std::size_t>(agent));
    if (question.request == nullptr || question.rpc != rpc) question.request.reset(request.New());
    question.rpc = rpc;
    if (listener_.needs_requests()) question.request->CopyFrom(request);
  }

  std::optional<Reply> heard(std::optional<Reply> reply) {
    if (!reply) return reply;
    const Question& question = questions_.at(static_cast<std::size_t>(reply->agent));
    const Message* answer = reply->player;
    if (reply->identity != nullptr) answer = reply->identity;
    if (reply->coach != nullptr) answer = reply->coach;
    if (reply->trainer != nullptr) answer = reply->trainer;
    if (reply->planner != nullptr) answer = reply->planner;
    if (reply->status.ok() && answer == nullptr) answer = &proto::reply_prototype(question.rpc);
    listener_.on_call(
        {reply->agent, question.rpc, *question.request, answer, reply->status, reply->latency});
    return reply;
  }

  void tell(int agent, Rpc rpc, const Message& request, const Message* reply,
            const RpcStatus& status, Clock::time_point start) {
    const auto latency =
        std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - start);
    listener_.on_call({agent, rpc, request, status.ok() ? reply : nullptr, status, latency});
  }

  RpcStatus told(int agent, Rpc rpc, const Message& request, RpcStatus status,
                 Clock::time_point start) {
    tell(agent, rpc, request, &proto::reply_prototype(rpc), status, start);
    return status;
  }

  Playmaker& inner_;
  RpcListener& listener_;
  std::array<Question, kAgentNumbers> questions_;
};

}  // namespace

std::unique_ptr<Playmaker> listen_to(Playmaker& inner, RpcListener& listener) {
  return std::make_unique<ListenedPlaymaker>(inner, listener);
}

}  // namespace cls::proxy
