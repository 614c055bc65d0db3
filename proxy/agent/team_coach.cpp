// A team's coach, or a trainer, in the cycles of a team.
#include <cassert>
#include <utility>

#include "proxy/agent/team.h"

namespace cls::proxy {

base::Result<void> Team::connect_coach(soccer::CoachRole role, const OpenChannel& open,
                                       const Serve& serve) {
  const bool trainer = role == soccer::CoachRole::kTrainer;
  const std::string who = trainer ? "trainer: " : name_ + ", coach: ";
  std::unique_ptr<soccer::Channel> channel = open();
  if (channel == nullptr) return base::Error{who + "no connection to the soccer server"};
  CoachOptions options;
  options.role = role;
  options.team_name = trainer ? soccer::TeamName() : options_.name;
  options.protocol = options_.protocol;
  auto coach = std::make_unique<CoachAgent>(std::move(channel), options);
  if (const base::Result<void> entered = enter(*coach, serve); !entered) {
    return base::Error{who + entered.error().message};
  }
  coach_ = std::move(coach);
  return {};
}

RpcStatus Team::introduce_coach() {
  const bool trainer = coach_->is_trainer();
  protos::RegisterRequest who;
  who.set_agent_type(trainer ? protos::TrainerT : protos::CoachT);
  who.set_team_name(name_);
  who.set_uniform_number(coach_->number());
  Correspondence& calls = correspondence_[static_cast<std::size_t>(coach_->number())].emplace(
      coach_->number(), trainer ? proto::Rpc::kGetTrainerActions : proto::Rpc::kGetCoachActions,
      who, coach_->world().parameters);
  RpcStatus status = calls.introduce(*playmaker_, options_.start_timeout, coach_->question());
  if (const std::string remark = calls.take_remark(); !remark.empty()) warn_once(remark);
  if (!status.ok()) status.message = coach_->word() + (": " + status.message);
  return status;
}

const WorldModel& Team::world() const {
  assert((!players_.empty() || coach_ != nullptr) && "a team is connected before it believes");
  return players_.empty() ? coach_->world() : players_.front()->world();
}

// Its call flies with those of the players.
int Team::ask_coach(Instant now) {
  if (coach_ == nullptr) return 0;
  coach_->perceive();
  if (!coach_->decision_due()) return 0;
  if (!coach_->asks()) {
    coach_->act_without_reply();
    return 0;
  }
  coach_->state();
  AskingTime time;
  time.timeout = coach_timeout(now);
  time.server_waits = synchronous();
  time.reconnect_within = options_.reconnect_within;
  correspondence(coach_->number()).ask(*playmaker_, coach_->question(), time);
  return 1;
}

// In real time nobody waits for a coach; what comes in the next cycle is still of use.
RpcTimeout Team::coach_timeout(Instant now) const {
  return players_.empty() ? options_.decision_timeout : decision_timeout(*players_.front(), now);
}

void Team::carry_out_coach(Reply reply) {
  Correspondence& calls = correspondence(reply.agent);
  const bool decided = calls.take(*playmaker_, reply);
  if (const std::string remark = calls.take_remark(); !remark.empty()) warn_once(remark);
  if (!decided) return;
  --outstanding_;
  if (reply.status.outcome == RpcOutcome::kUnimplemented) {
    // Playmakers need not have a coach. A trainer is there because somebody asked for one.
    coach_->stop_asking();
    if (coach_->is_trainer()) warn_once("the Playmaker has no GetTrainerActions: no trainer");
    coach_->act_without_reply();
    return;
  }
  coach_->statistics().count(reply);
  if (reply.coach != nullptr) {
    coach_->act(*reply.coach);
  } else if (reply.trainer != nullptr) {
    coach_->act(*reply.trainer);
  } else {
    coach_->act_without_reply();
    if (reply.status.outcome == RpcOutcome::kError) {
      warn_once(std::string("the Playmaker's ") + coach_->word() +
                " fails: " + reply.status.message);
    }
  }
  if (coach_->report().unknown > 0) {
    warn_once(std::string("the Playmaker's ") + coach_->word() +
              " asks for an action that this proxy does not have: skipped");
  }
  warn_of_server(coach_->server().trouble);
}

}  // namespace cls::proxy
