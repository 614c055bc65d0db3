// Saves replies at a cycle; compares situations.
#include "match/hooks/match_saver.h"

#include <fmt/format.h>

#include "base/system/version.h"
#include "proto/saved_match_file.h"

namespace cls::match {

void RepliesOfSide::on_call(const proxy::RpcCall& call) {
  if (!saving_) return;
  if (!is_decision(call.rpc) && call.rpc != proto::Rpc::kGetBestPlannerAction) return;

  saved::SavedReply& reply = replies_[call.agent].emplace_back();
  reply.set_side(side_number(side_));
  reply.set_agent(call.agent);
  reply.set_rpc(std::string(name(call.rpc)));
  if (call.reply != nullptr) call.reply->SerializeToString(reply.mutable_reply());
  reply.set_outcome(static_cast<int>(call.status.outcome));
  reply.set_code(call.status.code);
  reply.set_message(call.status.message);
}

void RepliesOfSide::move_to(saved::SavedMatch& match) {
  for (auto& [agent, replies] : replies_) {
    for (saved::SavedReply& reply : replies) *match.add_replies() = std::move(reply);
  }
  replies_.clear();
  saving_ = false;
}

bool MatchSaver::after_cycle(const MatchView& view) {
  ++steps_;
  last_cycle_ = view.progress.cycle;
  if (saved_ || view.progress.cycle < cycle_) return true;

  saved_ = true;
  match_.set_cycle(view.progress.cycle);
  match_.set_steps(steps_);
  match_.set_situation(situation_of(*view.world));
  for (RepliesOfSide* side : {&sides_.left, &sides_.right}) side->move_to(match_);
  error_ = proto::write_saved_match(file_.string(), std::move(match_));
  return true;
}

std::string MatchSaver::close() {
  if (saved_) return error_;
  return fmt::format("--save-at {}: the match ended at cycle {}; {} was not written", cycle_,
                     last_cycle_, file_.string());
}

bool ResumeCheck::after_cycle(const MatchView& view) {
  if (++steps_ == match_->steps()) differs_ = situation_of(*view.world) != match_->situation();
  return !differs_;
}

std::string ResumeCheck::problem() const {
  if (!differs_) return {};
  return fmt::format(
      "--resume: the match differs from the saved one at cycle {}; it was saved by cls {}, this is "
      "cls {}",
      match_->cycle(), match_->cls(), base::kVersion);
}

}  // namespace cls::match
