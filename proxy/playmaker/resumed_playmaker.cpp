// Saved replies first, calls afterwards.
#include "proxy/playmaker/resumed_playmaker.h"

#include <array>
#include <utility>

#include "proxy/playmaker/replies.h"

namespace cls::proxy {
namespace {

using google::protobuf::Message;
using proto::Rpc;

class ResumedPlaymaker : public Playmaker {
 public:
  ResumedPlaymaker(std::unique_ptr<Playmaker> inner, SavedReplies saved)
      : inner_(std::move(inner)), saved_(std::move(saved)) {}

  void announce_team(TeamRegistration team) override { inner_->announce_team(std::move(team)); }

  void begin(int agent, Rpc rpc, const Message& request, RpcTimeout timeout,
             bool wait_for_ready) override {
    std::deque<SavedReply>& own = saved_[agent];
    const bool saves = is_decision(rpc) || rpc == Rpc::kGetBestPlannerAction;
    if (!saves || own.empty()) return inner_->begin(agent, rpc, request, timeout, wait_for_ready);
    replies_.push_back(take(agent, rpc, own));
  }

  void send() override { inner_->send(); }
  Reply call(int agent, Rpc rpc, const Message& request, RpcTimeout timeout) override {
    return inner_->call(agent, rpc, request, timeout);
  }
  bool take_connection_loss(int agent) override { return inner_->take_connection_loss(agent); }

  std::optional<Reply> next_reply() override {
    if (std::optional<Reply> reply = known_reply()) return reply;
    return inner_->next_reply();
  }
  std::optional<Reply> next_reply_within(std::chrono::microseconds timeout) override {
    if (std::optional<Reply> reply = known_reply()) return reply;
    return inner_->next_reply_within(timeout);
  }

  std::string take_warning() override { return inner_->take_warning(); }
  void cancel() override { inner_->cancel(); }

 private:
  Reply take(int agent, Rpc rpc, std::deque<SavedReply>& own) {
    SavedReply saved = std::move(own.front());
    own.pop_front();
    if (saved.rpc != rpc) {
      // Another match: its caller compares the situation with the saved one.
      own.clear();
      return failed_reply(agent, rpc, {RpcOutcome::kError, 0, "the saved match has another call"});
    }
    if (!saved.status.ok()) return failed_reply(agent, rpc, std::move(saved.status));
    Reply reply = empty_reply(agent, rpc);
    memory_.at(static_cast<std::size_t>(agent)).parse(saved.message, reply);
    return reply;
  }

  std::optional<Reply> known_reply() {
    if (replies_.empty()) return std::nullopt;
    Reply reply = std::move(replies_.front());
    replies_.pop_front();
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
