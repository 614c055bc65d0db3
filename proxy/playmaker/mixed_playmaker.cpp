// Calls by agent, and replies from all parts.
#include "proxy/playmaker/mixed_playmaker.h"

#include <algorithm>
#include <utility>

#include "base/index.h"

namespace cls::proxy {
namespace {

using google::protobuf::Message;
using proto::Rpc;
using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;

// Without waiting for the other parts longer than this, a reply of one is handled in time.
constexpr microseconds kPartInterval{500};

class MixedPlaymaker : public Playmaker {
 public:
  MixedPlaymaker(std::vector<std::unique_ptr<Playmaker>> parts, const PartOfAgent& part_of)
      : parts_(std::move(parts)), part_of_(part_of), outstanding_(parts_.size(), 0) {}

  void announce_team(TeamRegistration team) override {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      TeamRegistration part = team;
      std::erase_if(part.agents, [&](const auto& agent) { return index_of(agent.first) != i; });
      if (!part.agents.empty()) parts_[i]->announce_team(std::move(part));
    }
  }

  void begin(int agent, Rpc rpc, const Message& request, RpcTimeout timeout,
             bool wait_for_ready) override {
    ++outstanding_[index_of(agent)];
    parts_[index_of(agent)]->begin(agent, rpc, request, timeout, wait_for_ready);
  }

  void send() override {
    for (const auto& part : parts_) part->send();
  }

  Reply call(int agent, Rpc rpc, const Message& request, RpcTimeout timeout) override {
    return parts_[index_of(agent)]->call(agent, rpc, request, timeout);
  }

  bool take_connection_loss(int agent) override {
    return parts_[index_of(agent)]->take_connection_loss(agent);
  }

  // All calls are in flight: waiting for one part delays none of the others.
  std::optional<Reply> next_reply() override {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (outstanding_[i] == 0) continue;
      if (auto reply = received(i, parts_[i]->next_reply())) return reply;
    }
    return std::nullopt;
  }

  std::optional<Reply> next_reply_within(microseconds timeout) override {
    const auto until = Clock::now() + timeout;
    while (true) {
      bool waits = false;
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (outstanding_[i] == 0) continue;
        const auto rest = std::chrono::duration_cast<microseconds>(until - Clock::now());
        const microseconds share = std::clamp(rest, microseconds(0), kPartInterval);
        if (auto reply = received(i, parts_[i]->next_reply_within(share))) return reply;
        waits = true;
      }
      if (!waits || Clock::now() >= until) return std::nullopt;
    }
  }

  std::string take_warning() override {
    for (const auto& part : parts_) {
      if (std::string warning = part->take_warning(); !warning.empty()) return warning;
    }
    return {};
  }

  void cancel() override {
    for (const auto& part : parts_) part->cancel();
  }

 private:
  std::size_t index_of(int agent) const { return part_of_.at(base::index(agent)); }

  std::optional<Reply> received(std::size_t part, std::optional<Reply> reply) {
    if (reply) --outstanding_[part];
    return reply;
  }

  std::vector<std::unique_ptr<Playmaker>> parts_;
  PartOfAgent part_of_;
  std::vector<int> outstanding_;  // calls of each part without a reply
};

}  // namespace

std::unique_ptr<Playmaker> make_mixed_playmaker(std::vector<std::unique_ptr<Playmaker>> parts,
                                                const PartOfAgent& part_of) {
  return std::make_unique<MixedPlaymaker>(std::move(parts), part_of);
}

}  // namespace cls::proxy
