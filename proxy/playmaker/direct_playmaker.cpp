// Calls of a function, with replies that wait for next_reply().
#include "proxy/playmaker/direct_playmaker.h"

#include <atomic>
#include <cassert>
#include <utility>
#include <vector>

#include "base/index.h"
#include "proxy/playmaker/replies.h"

namespace cls::proxy {
namespace {

using google::protobuf::Message;
using proto::Rpc;

class DirectPlaymaker : public Playmaker {
 public:
  explicit DirectPlaymaker(FallibleHandler handler) : handler_(std::move(handler)) {}

  void begin(int agent, Rpc rpc, const Message& request, RpcTimeout /*timeout*/,
             bool /*wait_for_ready*/) override {
    replies_.push_back(cancelled_ ? cancelled_reply(agent, rpc) : reply_to(agent, rpc, request));
  }

  Reply call(int agent, Rpc rpc, const Message& request, RpcTimeout /*timeout*/) override {
    assert(replies_.empty() && "blocking calls do not mix with outstanding ones");
    if (cancelled_ && rpc != Rpc::kSendByeCommand) return cancelled_reply(agent, rpc);
    return reply_to(agent, rpc, request);
  }

  bool take_connection_loss(int /*agent*/) override { return false; }

  std::optional<Reply> next_reply() override {
    if (replies_.empty()) return std::nullopt;
    Reply reply = std::move(replies_[returned_++]);
    if (returned_ == replies_.size()) {
      replies_.clear();
      returned_ = 0;
    }
    return reply;
  }

  std::optional<Reply> next_reply_within(std::chrono::microseconds /*timeout*/) override {
    return next_reply();
  }

  void cancel() override { cancelled_ = true; }

 private:
  Reply reply_to(int agent, Rpc rpc, const Message& request) {
    const auto started = std::chrono::steady_clock::now();
    Message& message = memories_.at(base::index(agent)).create(rpc);
    Reply reply = failed_reply(agent, rpc, handler_(rpc, request, message));
    if (reply.status.ok()) reply.message = &message;
    reply.latency = std::chrono::duration_cast<std::chrono::microseconds>(
        std::chrono::steady_clock::now() - started);
    return reply;
  }

  FallibleHandler handler_;
  std::array<ReplyMemory, kAgentNumbers> memories_;
  std::vector<Reply> replies_;  // in the order of the calls; those before `returned_` are taken
  std::size_t returned_ = 0;
  std::atomic<bool> cancelled_{false};
};

}  // namespace

std::unique_ptr<Playmaker> make_direct_playmaker(DirectHandler handler) {
  return make_fallible_playmaker(
      [handler = std::move(handler)](Rpc rpc, const Message& request, Message& reply) {
        handler(rpc, request, reply);
        return RpcStatus{};
      });
}

std::unique_ptr<Playmaker> make_fallible_playmaker(FallibleHandler handler) {
  return std::make_unique<DirectPlaymaker>(std::move(handler));
}

}  // namespace cls::proxy
