// Saved replies first, calls afterwards.
#include "proxy/playmaker/resumed_playmaker.h"

#include <array>
#include <utility>

#include "base/index.h"
#include "proxy/playmaker/forwarding_playmaker.h"
#include "proxy/playmaker/replies.h"

namespace cls::proxy {
namespace {

using google::protobuf::Message;
using proto::Rpc;

class ResumedPlaymaker : public ForwardingPlaymaker {
 public:
  ResumedPlaymaker(std::unique_ptr<Playmaker> inner, SavedReplies saved)
      : ForwardingPlaymaker(*inner), inner_(std::move(inner)), saved_(std::move(saved)) {}

  void begin(int agent, Rpc rpc, const Message& request, RpcTimeout timeout,
             bool wait_for_ready) override {
    std::deque<SavedReply>& own = saved_[agent];
    const bool saves = is_decision(rpc) || rpc == Rpc::kGetBestPlannerAction;
    if (!saves || own.empty()) {
      return ForwardingPlaymaker::begin(agent, rpc, request, timeout, wait_for_ready);
    }
    replies_.push_back(take(agent, rpc, own));
  }

  std::optional<Reply> next_reply() override {
    if (!replies_.empty()) return take_first(replies_);
    return ForwardingPlaymaker::next_reply();
  }
  std::optional<Reply> next_reply_within(std::chrono::microseconds timeout) override {
    if (!replies_.empty()) return take_first(replies_);
    return ForwardingPlaymaker::next_reply_within(timeout);
  }

 private:
  Reply take(int agent, Rpc rpc, std::deque<SavedReply>& own) {
    SavedReply saved = take_first(own);
    if (saved.rpc != rpc) {
      // Another match: its caller compares the situation with the saved one.
      own.clear();
      return failed_reply(agent, rpc, {RpcOutcome::kError, 0, "the saved match has another call"});
    }
    if (!saved.status.ok()) return failed_reply(agent, rpc, std::move(saved.status));

    Reply reply = empty_reply(agent, rpc);
    memory_.at(base::index(agent)).parse(saved.message, reply);
    return reply;
  }

  std::unique_ptr<Playmaker> inner_;
  SavedReplies saved_;
  std::deque<Reply> replies_;
  std::array<ReplyMemory, kAgentNumbers> memory_;
};

}  // namespace

std::unique_ptr<Playmaker> resume_with(std::unique_ptr<Playmaker> inner, SavedReplies replies) {
  return std::make_unique<ResumedPlaymaker>(std::move(inner), std::move(replies));
}

}  // namespace cls::proxy
