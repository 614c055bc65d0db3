// The Playmaker decorator that notes the begin and the end of calls.
#include "proxy/playmaker/call_watch.h"

#include <cstddef>

#include "base/index.h"
#include "proxy/playmaker/forwarding_playmaker.h"

namespace cls::proxy {
namespace {

using google::protobuf::Message;
using proto::Rpc;

// Calls of one cycle begin within this time, in an order that depends on the server's messages.
constexpr std::chrono::milliseconds kSameCycle{100};

class WatchedPlaymaker : public ForwardingPlaymaker {
 public:
  WatchedPlaymaker(Playmaker& inner, CallWatch& watch)
      : ForwardingPlaymaker(inner), watch_(watch) {}

  void begin(int agent, Rpc rpc, const Message& request, RpcTimeout timeout,
             bool wait_for_ready) override {
    watch_.begin(agent, rpc);
    ForwardingPlaymaker::begin(agent, rpc, request, timeout, wait_for_ready);
  }

  Reply call(int agent, Rpc rpc, const Message& request, RpcTimeout timeout) override {
    watch_.begin(agent, rpc);
    Reply reply = ForwardingPlaymaker::call(agent, rpc, request, timeout);
    watch_.end(agent);
    return reply;
  }

  void on_reply(const Reply& reply) override { watch_.end(reply.agent); }

 private:
  CallWatch& watch_;
};

}  // namespace

void CallWatch::begin(int agent, Rpc rpc) {
  Call& call = calls_.at(base::index(agent));
  call.rpc.store(rpc, std::memory_order_relaxed);
  call.begun.store(Clock::now().time_since_epoch().count(), std::memory_order_release);
}

void CallWatch::end(int agent) {
  calls_.at(base::index(agent)).begun.store(0, std::memory_order_release);
}

std::optional<AwaitedCall> CallWatch::oldest() const {
  std::array<Clock::rep, kAgentNumbers> begun{};  // 0: not awaited
  Clock::rep first = 0;
  int awaited = 0;

  for (std::size_t agent = 1; agent < begun.size(); ++agent) {
    begun[agent] = calls_[agent].begun.load(std::memory_order_acquire);
    if (begun[agent] == 0) continue;
    ++awaited;
    if (first == 0 || begun[agent] < first) first = begun[agent];
  }
  if (awaited == 0) return std::nullopt;

  AwaitedCall oldest;
  for (std::size_t agent = 1; agent < begun.size() && oldest.agent == 0; ++agent) {
    if (begun[agent] == 0 || Clock::duration(begun[agent] - first) > kSameCycle) continue;
    oldest.agent = static_cast<int>(agent);
    oldest.rpc = calls_[agent].rpc.load(std::memory_order_relaxed);
  }

  oldest.waited = Clock::now().time_since_epoch() - Clock::duration(first);
  oldest.others = awaited - 1;
  return oldest;
}

std::unique_ptr<Playmaker> watch_calls(Playmaker& inner, CallWatch& watch) {
  return std::make_unique<WatchedPlaymaker>(inner, watch);
}

}  // namespace cls::proxy
