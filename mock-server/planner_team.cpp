// One action or two for each kind of situation.
#include "mock-server/planner_team.h"

namespace cls::mock_server {
namespace {

void plan(protos::HeliosOffensivePlanner& planner) {
  planner.set_direct_pass(true);
  planner.set_lead_pass(true);
  planner.set_through_pass(true);
  planner.set_short_dribble(true);
  planner.set_long_dribble(true);
  planner.set_cross(true);
  planner.set_simple_pass(true);
  planner.set_simple_dribble(true);
  planner.set_simple_shoot(true);
}

}  // namespace

void PlannerTeam::decide(const protos::State& state, protos::PlayerActions& actions) const {
  const protos::WorldModel& world = state.world_model();
  if (world.is_penalty_kick_mode()) {
    actions.add_actions()->mutable_helios_penalty();
  } else if (world.game_mode_type() != protos::PlayOn) {
    actions.add_actions()->mutable_helios_set_play();
  } else if (world.self().is_goalie()) {
    actions.add_actions()->mutable_helios_goalie();
  } else if (world.self().is_kickable()) {
    actions.add_actions()->mutable_helios_shoot();
    plan(*actions.add_actions()->mutable_helios_offensive_planner());
  } else {
    actions.add_actions()->mutable_helios_basic_move();
  }
}

void PlannerTeam::decide_as_coach(const protos::State& /*state*/,
                                  protos::CoachActions& actions) const {
  actions.add_actions()->mutable_do_helios_substitute();
  actions.add_actions()->mutable_do_helios_say_player_types();
}

}  // namespace cls::mock_server
