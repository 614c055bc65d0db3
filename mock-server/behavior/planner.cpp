// High-level actions by play mode and ball possession.
#include "mock-server/behavior/bundled.h"

namespace cls::mock_server {
namespace {

void enable_all(protos::HeliosOffensivePlanner& planner) {
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

class PlannerBehavior : public Behavior {
 public:
  void decide(const protos::State& state, protos::PlayerActions& actions) const override {
    const protos::WorldModel& world = state.world_model();

    if (world.is_penalty_kick_mode()) {
      actions.add_actions()->mutable_helios_penalty();
    } else if (world.game_mode_type() != protos::PlayOn) {
      actions.add_actions()->mutable_helios_set_play();
    } else if (world.self().is_goalie()) {
      actions.add_actions()->mutable_helios_goalie();
    } else if (world.self().is_kickable()) {
      actions.add_actions()->mutable_helios_shoot();
      enable_all(*actions.add_actions()->mutable_helios_offensive_planner());
    } else {
      actions.add_actions()->mutable_helios_basic_move();
    }
  }

  void decide_as_coach(const protos::State& /*state*/,
                       protos::CoachActions& actions) const override {
    actions.add_actions()->mutable_do_helios_substitute();
    actions.add_actions()->mutable_do_helios_say_player_types();
  }
};

}  // namespace

std::unique_ptr<Behavior> make_planner_behavior() { return std::make_unique<PlannerBehavior>(); }

}  // namespace cls::mock_server
