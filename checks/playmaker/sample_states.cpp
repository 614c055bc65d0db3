// Sample States.
#include "checks/playmaker/sample_states.h"

#include <google/protobuf/unknown_field_set.h>

#include <cmath>

#include "soccer/side.h"

namespace cls::checks {
namespace {

constexpr int kForever = 1000;
constexpr int kUnknownField = 999;

void set_vector(protos::RpcVector2D& v, double x, double y) {
  v.set_x(static_cast<float>(x));
  v.set_y(static_cast<float>(y));
  v.set_dist(static_cast<float>(std::sqrt(x * x + y * y)));
}

void set_unseen(protos::RpcVector2D& v, float value) {
  v.Clear();
  v.set_x(value);
  v.set_y(value);
}

// Rows of three in front of the own goal, mirrored for opponents.
void place(protos::Player& player, protos::Side side, int unum, bool ours) {
  const double sign = ours ? 1.0 : -1.0;
  const double x = sign * (unum == 1 ? -50.0 : -12.0 * (4 - (unum - 2) / 3));
  const double y = unum == 1 ? 0.0 : 12.0 * ((unum - 2) % 3 - 1);

  set_vector(*player.mutable_position(), x, y);
  set_vector(*player.mutable_seen_position(), x, y);
  set_vector(*player.mutable_velocity(), 0.1 * sign, 0.0);
  player.set_side(side);
  player.set_uniform_number(unum);
  player.set_is_goalie(unum == 1);
  player.set_id((ours ? 0 : 11) + unum);
  player.set_dist_from_ball(static_cast<float>(std::sqrt(x * x + y * y)));
  player.set_ball_reach_steps(5 + unum);
}

void fill_players(protos::WorldModel& world, int own_number) {
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    protos::Player ours;
    place(ours, world.our_side(), unum, true);
    if (unum != own_number) *world.add_teammates() = ours;
    (*world.mutable_our_players_dict())[unum] = ours;

    protos::Player theirs;
    place(theirs, world.our_side() == protos::LEFT ? protos::RIGHT : protos::LEFT, unum, false);
    *world.add_opponents() = theirs;
    (*world.mutable_their_players_dict())[unum] = theirs;
    (*world.mutable_helios_home_positions())[unum] = ours.position();
  }
}

void fill_self(protos::Self& self, const protos::WorldModel& world, int unum) {
  self.set_uniform_number(unum);
  self.set_side(world.our_side());
  self.set_is_goalie(unum == 1);
  self.set_id(unum);
  self.set_stamina(7000.0f);
  self.set_stamina_capacity(120000.0f);
  self.set_effort(1.0f);
  self.set_recovery(1.0f);
  self.set_kick_rate(0.027f);
  self.set_view_width(protos::NORMAL);
  self.set_ball_reach_steps(5 + unum);
  self.set_get_safety_dash_power(100.0f);

  const auto own = world.our_players_dict().find(unum);
  if (own == world.our_players_dict().end()) return;

  *self.mutable_position() = own->second.position();
  *self.mutable_seen_position() = own->second.position();
  *self.mutable_velocity() = own->second.velocity();
  self.set_dist_from_ball(own->second.dist_from_ball());
}

void fill_intercepts(protos::InterceptTable& table) {
  table.set_self_reach_steps(8);
  table.set_first_teammate_reach_steps(6);
  table.set_second_teammate_reach_steps(9);
  table.set_first_opponent_reach_steps(7);
  table.set_second_opponent_reach_steps(11);
  table.set_first_teammate_id(9);
  table.set_first_opponent_id(20);

  protos::InterceptInfo& way = *table.add_self_intercept_info();
  way.set_action_type(protos::TURN_FORWARD_DASH);
  way.set_turn_steps(1);
  way.set_dash_steps(7);
  way.set_dash_power(100.0f);
  set_vector(*way.mutable_final_self_position(), 1.0, 1.0);
}

void forget(protos::Player& player, float unseen) {
  for (protos::RpcVector2D* v :
       {player.mutable_position(), player.mutable_seen_position(), player.mutable_heard_position(),
        player.mutable_velocity(), player.mutable_seen_velocity()}) {
    set_unseen(*v, unseen);
  }
  player.set_pos_count(kForever);
  player.set_seen_pos_count(kForever);
  player.set_heard_pos_count(kForever);
  player.set_vel_count(kForever);
  player.set_seen_vel_count(kForever);
  player.set_body_direction_count(kForever);
  player.set_face_direction_count(kForever);
  player.set_ball_reach_steps(kForever);
}

void forget(protos::Ball& ball, float unseen) {
  for (protos::RpcVector2D* v :
       {ball.mutable_position(), ball.mutable_relative_position(), ball.mutable_seen_position(),
        ball.mutable_heard_position(), ball.mutable_velocity(), ball.mutable_seen_velocity(),
        ball.mutable_heard_velocity()}) {
    set_unseen(*v, unseen);
  }
  ball.set_pos_count(kForever);
  ball.set_seen_pos_count(kForever);
  ball.set_heard_pos_count(kForever);
  ball.set_vel_count(kForever);
  ball.set_seen_vel_count(kForever);
  ball.set_heard_vel_count(kForever);
  ball.set_lost_count(kForever);
}

void add_unknown(google::protobuf::Message& message) {
  google::protobuf::UnknownFieldSet* fields =
      message.GetReflection()->MutableUnknownFields(&message);
  fields->AddVarint(kUnknownField, 42);
  fields->AddLengthDelimited(kUnknownField + 1, "of a later version");
}

}  // namespace

protos::State ordinary_state(const protos::RegisterResponse& identity, int cycle) {
  protos::State state;
  *state.mutable_register_response() = identity;
  protos::WorldModel& world = *state.mutable_world_model();
  world.set_our_team_name(identity.team_name());
  world.set_their_team_name("Opponents");
  world.set_our_side(protos::LEFT);
  world.set_cycle(cycle);
  world.set_see_time(cycle);
  world.set_game_mode_type(protos::PlayOn);
  world.set_game_mode_side(protos::UNKNOWN);
  world.set_offside_line_x(20.0f);
  world.set_our_goalie_uniform_number(1);
  world.set_their_goalie_uniform_number(1);
  world.set_our_defense_line_x(-36.0);
  world.set_their_defense_line_x(36.0);

  fill_players(world, identity.uniform_number());
  if (identity.agent_type() == protos::PlayerT) {
    fill_self(*world.mutable_self(), world, identity.uniform_number());
    fill_intercepts(*world.mutable_intercept_table());
  }

  protos::Ball& ball = *world.mutable_ball();
  set_vector(*ball.mutable_position(), 1.5, -0.5);
  set_vector(*ball.mutable_seen_position(), 1.5, -0.5);
  set_vector(*ball.mutable_velocity(), 0.4, 0.1);

  return state;
}

void forget_everything(protos::State& state, float unseen) {
  protos::WorldModel& world = *state.mutable_world_model();
  forget(*world.mutable_ball(), unseen);
  world.clear_teammates();
  world.clear_opponents();
  for (auto& [unum, player] : *world.mutable_our_players_dict()) forget(player, unseen);
  for (auto& [unum, player] : *world.mutable_their_players_dict()) forget(player, unseen);

  protos::Self& self = *world.mutable_self();
  self.set_pos_count(kForever);
  self.set_seen_pos_count(kForever);
  self.set_vel_count(kForever);
  self.set_ball_reach_steps(kForever);
  set_unseen(*self.mutable_heard_position(), unseen);

  protos::InterceptTable& table = *world.mutable_intercept_table();
  table.Clear();
  table.set_self_reach_steps(kForever);
  table.set_first_teammate_reach_steps(kForever);
  table.set_first_opponent_reach_steps(kForever);
}

void remove_newer_fields(protos::State& state) {
  protos::WorldModel& world = *state.mutable_world_model();
  world.mutable_self()->clear_get_safety_dash_power();
  if (world.has_penalty_kick_state()) world.mutable_penalty_kick_state()->clear_cycle();

  const auto reduce = [](protos::Player& player) {
    player.clear_inertia_final_point();
    player.clear_body_count();
  };

  for (protos::Player& player : *world.mutable_teammates()) reduce(player);
  for (protos::Player& player : *world.mutable_opponents()) reduce(player);
  for (auto& [unum, player] : *world.mutable_our_players_dict()) reduce(player);
  for (auto& [unum, player] : *world.mutable_their_players_dict()) reduce(player);
}

void add_unknown_fields(protos::State& state) {
  add_unknown(state);
  add_unknown(*state.mutable_world_model());
  add_unknown(*state.mutable_world_model()->mutable_self());
}

protos::BestPlannerActionRequest planner_request(const protos::State& state, int candidates) {
  protos::BestPlannerActionRequest request;
  *request.mutable_register_response() = state.register_response();

  *request.mutable_state() = state;

  for (int index = 1; index <= candidates; ++index) {
    protos::RpcActionState& node = (*request.mutable_pairs())[index];
    protos::RpcCooperativeAction& action = *node.mutable_action();
    action.set_category(protos::AC_Pass);
    action.set_index(index);
    action.set_sender_unum(state.register_response().uniform_number());
    action.set_target_unum(2 + index % 10);
    action.set_parent_index(-1);
    action.set_duration_step(5);
    action.set_final_action(true);
    set_vector(*action.mutable_target_point(), index % 50, index % 30);
    node.mutable_predict_state()->set_ball_holder_unum(action.target_unum());
    node.set_evaluation(index);
  }
  return request;
}

}  // namespace cls::checks
