// The Playmaker decorator that reports calls to an RpcListener.
#include "proxy/playmaker/rpc_listener.h"

#include <array>

#include "base/index.h"
#include "proxy/playmaker/forwarding_playmaker.h"

namespace cls::proxy {
namespace {

using google::protobuf::Message;
using proto::Rpc;

class ObservedPlaymaker : public ForwardingPlaymaker {
 public:
  ObservedPlaymaker(Playmaker& inner, RpcListener& listener)
      : ForwardingPlaymaker(inner), listener_(listener) {}

  void begin(int agent, Rpc rpc, const Message& request, RpcTimeout timeout,
             bool wait_for_ready) override {
    auto& copy = requests_.at(base::index(agent));
    if (copy == nullptr || copy->GetDescriptor() != request.GetDescriptor()) {
      copy.reset(request.New());
    }
    if (listener_.needs_requests()) copy->CopyFrom(request);
    ForwardingPlaymaker::begin(agent, rpc, request, timeout, wait_for_ready);
  }

  Reply call(int agent, Rpc rpc, const Message& request, RpcTimeout timeout) override {
    Reply reply = ForwardingPlaymaker::call(agent, rpc, request, timeout);
    report(reply, request);
    return reply;
  }

  void on_reply(const Reply& reply) override {
    report(reply, *requests_.at(base::index(reply.agent)));
  }

 private:
  void report(const Reply& reply, const Message& request) {
    listener_.on_call(
        {reply.agent, reply.rpc, request, reply.message, reply.status, reply.latency});
  }

  RpcListener& listener_;
  std::array<std::unique_ptr<Message>, kAgentNumbers> requests_;  // of outstanding calls; reused
};

}  // namespace

std::unique_ptr<Playmaker> listen_to(Playmaker& inner, RpcListener& listener) {
  return std::make_unique<ObservedPlaymaker>(inner, listener);
}

}  // namespace cls::proxy
