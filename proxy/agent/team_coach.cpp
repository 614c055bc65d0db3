// The coach or trainer of a team.
#include <algorithm>
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
  options.graphic = options_.graphic;
  if (!trainer) options.planner = options_.planner;

  auto coach = std::make_unique<CoachAgent>(std::move(channel), options);
  if (const base::Result<void> entered = connect_agent(*coach, serve); !entered) {
    return base::Error{who + entered.error().message};
  }
  coach_ = std::move(coach);
  return {};
}

protos::RegisterRequest Team::coach_registration() const {
  protos::RegisterRequest who;
  who.set_agent_type(coach_->is_trainer() ? protos::TrainerT : protos::CoachT);
  who.set_team_name(name_);
  who.set_uniform_number(coach_->number());
  return who;
}

RpcStatus Team::register_coach() {
  return register_agent(
      *coach_, coach_->number(),
      coach_->is_trainer() ? proto::Rpc::kGetTrainerActions : proto::Rpc::kGetCoachActions,
      coach_registration(), coach_->role_name());
}

const player::WorldModel& Team::world() const {
  assert((!players_.empty() || coach_ != nullptr) && "the team is connected");
  return players_.empty() ? coach_->world() : players_.front()->world();
}

// Its call is in flight together with those of the players.
int Team::begin_coach_decision(Instant now) {
  if (coach_ == nullptr) return 0;
  coach_->perceive();
  if (!coach_->decision_due()) return 0;
  if (!coach_->requests_decisions()) {
    coach_->act_without_reply();
    return 0;
  }
  coach_->state();
  request_decision(*coach_, coach_->number(), coach_timeout(now), synchronous());
  return 1;
}

// In real time the server does not wait for a coach; a reply in the next cycle is still useful.
RpcTimeout Team::coach_timeout(Instant now) const {
  return players_.empty() ? options_.decision_timeout : decision_timeout(*players_.front(), now);
}

// The result of a decision.
void Team::handle_coach_reply(const Reply& reply) {
  if (reply.status.outcome == RpcOutcome::kUnimplemented) {
    // GetCoachActions is optional. A trainer exists because the user requested one.
    coach_->disable_requests();
    if (coach_->is_trainer()) {
      warn_once("the Playmaker does not implement GetTrainerActions: no trainer");
    }
    coach_->act_without_reply();
    return;
  }

  coach_->statistics().count(reply);
  count_error(reply, *coach_, coach_->mutable_state());
  if (const auto* orders = reply.as<protos::CoachActions>()) {
    coach_->act(*orders);
  } else if (const auto* trainer_orders = reply.as<protos::TrainerActions>()) {
    coach_->act(*trainer_orders);
  } else {
    coach_->act_without_reply();
  }

  if (coach_->report().unknown > 0) {
    warn_once(std::string("the Playmaker's ") + coach_->role_name() +
              " sends an action unknown to this proxy: skipped");
  }
  warn_of_coach_actions();
  warn_of_server(coach_->server().errors);
}

void Team::warn_of_coach_actions() {
  const auto& invalid = coach_->report().invalid;
  if (std::ranges::all_of(invalid, [](auto count) { return count == 0; })) return;

  for (const auto& [name, outcomes] : outcomes_by_name(coach_->report(), coach_->is_trainer())) {
    if (!outcomes.contains("invalid")) continue;
    warn_once(
        std::string("the Playmaker's ") + coach_->role_name() + " sends " + name +
        " with an unknown player, type or play mode, or a number that is not finite: ignored");
  }
}

}  // namespace cls::proxy
