// The Playmaker decorator that reports calls to an RpcListener.
#include "proxy/playmaker/rpc_listener.h"

#include <array>

namespace cls::proxy {
namespace {

using google::protobuf::Message;
using proto::Rpc;

class ObservedPlaymaker : public Playmaker {
 public:
  ObservedPlaymaker(Playmaker& inner, RpcListener& listener) : inner_(inner), listener_(listener) {}

  void begin(int agent, Rpc rpc, const Message& request, RpcTimeout timeout,
             bool wait_for_ready) override {
    auto& copy = requests_.at(static_cast<std::size_t>(agent));
    if (copy == nullptr || copy->GetDescriptor() != request.GetDescriptor()) {
      copy.reset(request.New());
    }
    if (listener_.needs_requests()) copy->CopyFrom(request);
    inner_.begin(agent, rpc, request, timeout, wait_for_ready);
  }

  void announce_team(TeamRegistration team) override { inner_.announce_team(std::move(team)); }
  void send() override { inner_.send(); }
  std::string take_warning() override { return inner_.take_warning(); }

  Reply call(int agent, Rpc rpc, const Message& request, RpcTimeout timeout) override {
    Reply reply = inner_.call(agent, rpc, request, timeout);
    report(reply, request);
    return reply;
  }

  bool take_connection_loss(int agent) override { return inner_.take_connection_loss(agent); }
  std::optional<Reply> next_reply() override { return reported(inner_.next_reply()); }
  std::optional<Reply> next_reply_within(std::chrono::microseconds timeout) override {
    return reported(inner_.next_reply_within(timeout));
  }
  void cancel() override { inner_.cancel(); }

 private:
  void report(const Reply& reply, const Message& request) {
    listener_.on_call(
        {reply.agent, reply.rpc, request, reply.message, reply.status, reply.latency});
  }

  std::optional<Reply> reported(std::optional<Reply> reply) {
    if (reply) report(*reply, *requests_.at(static_cast<std::size_t>(reply->agent)));
    return reply;
  }

  Playmaker& inner_;
  RpcListener& listener_;
  std::array<std::unique_ptr<Message>, kAgentNumbers> requests_;  // of outstanding calls; reused
};

}  // namespace

std::unique_ptr<Playmaker> listen_to(Playmaker& inner, RpcListener& listener) {
  return std::make_unique<ObservedPlaymaker>(inner, listener);
}

}  // namespace cls::proxy
