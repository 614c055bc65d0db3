// Cycles of server, players and coach.
#include "tests/proxy/coach/coached_match.h"

#include <stdexcept>
#include <utility>

#include "base/index.h"
#include "simulator/referee/referee.h"

namespace cls::tests {
namespace {

template <typename Agent>
void let_in(simulator::LockstepServer& server, Agent& agent) {
  agent.connect();
  server.accept_clients();
  agent.perceive();
  if (!agent.ready()) throw std::runtime_error("not accepted: " + agent.server().refusal);
}

}  // namespace

CoachedMatch::CoachedMatch(soccer::CoachRole role, soccer::Side side, bool noise, int half_time,
                           std::shared_ptr<const player::PlannerParameters> planner) {
  simulator::MatchConfig config;
  config.seed = 5;
  config.server.auto_mode = true;
  config.server.kick_off_wait = 20;
  config.server.half_time = half_time;
  config.server.coach_w_referee = role == soccer::CoachRole::kTrainer;
  if (!noise) config.server.player_rand = config.server.ball_rand = config.server.wind_force = 0.0;
  auto server = simulator::LockstepServer::create(config);
  if (!server) throw std::runtime_error(server.error().message);
  server_ = std::move(*server);
  players_.resize(soccer::kPlayersOnPitch);
  states_.resize(players_.size());

  for (std::size_t i = 0; i < players_.size(); ++i) {
    const bool left = i < soccer::kPlayersPerTeam;
    join(players_[i], left ? soccer::Side::kLeft : soccer::Side::kRight,
         i % soccer::kPlayersPerTeam == 0);
  }

  join_coach(role, side, std::move(planner));
}

void CoachedMatch::join(std::unique_ptr<proxy::PlayerAgent>& player, soccer::Side side,
                        bool goalie) {
  proxy::AgentOptions options;
  options.team_name = side == soccer::Side::kLeft ? "left" : "right";
  options.goalie = goalie;
  player = std::make_unique<proxy::PlayerAgent>(server_->connect(), options);
  let_in(*server_, *player);
}

void CoachedMatch::join_coach(soccer::CoachRole role, soccer::Side side,
                              std::shared_ptr<const player::PlannerParameters> planner) {
  const bool trainer = role == soccer::CoachRole::kTrainer;
  proxy::CoachOptions options;
  options.role = role;
  options.planner = std::move(planner);
  if (!trainer) options.team_name = side == soccer::Side::kLeft ? "left" : "right";
  coach_ = std::make_unique<proxy::CoachAgent>(
      server_->connect(trainer ? simulator::ListeningPort::kTrainers
                               : simulator::ListeningPort::kOnlineCoaches),
      options);
  let_in(*server_, *coach_);
}

void CoachedMatch::run(const std::function<void()>& decide) {
  server_->run_cycle();
  for (std::size_t i = 0; i < players_.size(); ++i) {
    proxy::PlayerAgent& player = *players_[i];
    player.perceive();
    states_[i] = player.state();
    protos::PlayerActions actions;
    actions.set_ignore_preprocess(true);
    actions.set_ignore_dointention(true);
    actions.set_ignore_doforcekick(true);
    actions.set_ignore_doheardpassrecieve(true);
    actions.set_ignore_shootinpreprocess(true);
    if (play) play(player, actions);
    player.act(actions);
  }

  coach_->perceive();
  if (!coach_->decision_due()) throw std::runtime_error("the coach was not asked to think");
  if (!coach_->requests_decisions()) return coach_->act_without_reply();
  state_ = coach_->state();
  decide();
}

void CoachedMatch::step_as_coach(const std::function<void(protos::CoachActions&)>& answer) {
  run([&] {
    protos::CoachActions actions;
    answer(actions);
    coach_->act(actions);
  });
}

void CoachedMatch::step_as_trainer(const std::function<void(protos::TrainerActions&)>& answer) {
  run([&] {
    protos::TrainerActions actions;
    answer(actions);
    coach_->act(actions);
  });
}

void CoachedMatch::steps(int count) {
  for (int i = 0; i < count; ++i) run([this] { coach_->act_without_reply(); });
}

void CoachedMatch::steps_until(soccer::PlayMode mode) {
  for (int i = 0; i < 400 && world().mode != mode; ++i) steps(1);
}

void CoachedMatch::arrange(const std::function<void(simulator::World&)>& change) {
  server_->modify_world([&](simulator::World& world, simulator::Events&) { change(world); });
}

void CoachedMatch::set_mode(soccer::PlayMode mode) {
  server_->modify_world([mode](simulator::World& world, simulator::Events& events) {
    simulator::change_mode(world, mode, events);
  });
}

proxy::PlayerAgent& CoachedMatch::player(soccer::Side side, int unum) {
  return *players_.at(base::index(soccer::slot_of(side, unum)));
}

const protos::WorldModel& CoachedMatch::world_model(soccer::Side side, int unum) const {
  return states_.at(base::index(soccer::slot_of(side, unum))).world_model();
}

}  // namespace cls::tests
