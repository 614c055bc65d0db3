// From a State to the situation of the simple team, from its actions to messages.
#include "mock-server/behavior/simple_team.h"

#include <utility>

#include "player/simple_team/simple_team.h"

namespace cls::mock_server {
namespace {

soccer::Vec2 point_of(const protos::RpcVector2D& vector) { return {vector.x(), vector.y()}; }

player::TeamMode mode_of(const protos::WorldModel& world) {
  if (world.is_penalty_kick_mode()) return player::TeamMode::kPenalty;

  using enum player::TeamMode;
  for (const auto& [wire, mode] : {std::pair{protos::PlayOn, kPlayOn},
                                   {protos::BeforeKickOff, kBeforeKickOff},
                                   {protos::AfterGoal_, kBeforeKickOff},
                                   {protos::KickOff_, kKickOff},
                                   {protos::GoalKick_, kGoalKick},
                                   {protos::GoalieCatch_, kGoalieCatch},
                                   {protos::FreeKick_, kFreeKick}}) {
    if (wire == world.game_mode_type()) return mode;
  }
  return kOther;
}

// Player id 0 in the intercept table: no player.
int reach(int steps, int player_id) { return player_id == 0 ? player::kNeverReached : steps; }

void read_self(const protos::Self& self, player::Situation& now) {
  now.unum = self.uniform_number();
  now.goalie = self.is_goalie();
  now.position = point_of(self.position());
  now.stamina = self.stamina();
  now.catch_probability = self.catch_probability();
  now.kickable = self.is_kickable();
}

void read_ball(const protos::WorldModel& world, player::Situation& now) {
  now.ball = point_of(world.ball().position());
  now.ball_velocity = point_of(world.ball().velocity());
  now.ball_age = world.ball().pos_count();

  const protos::InterceptTable& table = world.intercept_table();
  now.own_steps = table.self_reach_steps();
  now.teammates_steps = reach(table.first_teammate_reach_steps(), table.first_teammate_id());
  now.opponents_steps = reach(table.first_opponent_reach_steps(), table.first_opponent_id());
  now.teammate_kicks = world.kickable_teammate_existance();
  now.opponent_kicks = world.kickable_opponent_existance();
}

void set_point(const player::TeamAction& action, protos::RpcVector2D& vector) {
  vector.set_x(action.x);
  vector.set_y(action.y);
}

void set_smart_kick(const player::TeamAction& action, protos::Body_SmartKick& kick) {
  set_point(action, *kick.mutable_target_point());
  kick.set_first_speed(action.first);
  kick.set_first_speed_threshold(action.second);
  kick.set_max_steps(action.count);
}

void set_dribble(const player::TeamAction& action, protos::Body_Dribble& dribble) {
  set_point(action, *dribble.mutable_target_point());
  dribble.set_distance_threshold(player::kDribbleDistance);
  dribble.set_dash_power(action.first);
  dribble.set_dash_count(action.count);
  dribble.set_dodge(true);
}

void set_go_to(const player::TeamAction& action, protos::Body_GoToPoint& go) {
  set_point(action, *go.mutable_target_point());
  go.set_distance_threshold(action.first);
  go.set_max_dash_power(action.second);
}

void set_tackle(const player::TeamAction& action, protos::Body_TackleToPoint& tackle) {
  set_point(action, *tackle.mutable_target_point());
  tackle.set_min_probability(action.first);
}

void set_turn_to(const player::TeamAction& action, protos::Body_TurnToPoint& turn) {
  set_point(action, *turn.mutable_target_point());
  turn.set_cycle(1);
}

void write(const player::TeamAction& action, protos::PlayerAction& out) {
  using Kind = player::TeamAction::Kind;

  switch (action.kind) {
    case Kind::kSmartKick:
      return set_smart_kick(action, *out.mutable_body_smart_kick());
    case Kind::kDribble:
      return set_dribble(action, *out.mutable_body_dribble());
    case Kind::kClearBall:
      out.mutable_body_clear_ball();
      return;
    case Kind::kIntercept:
      return set_point(action, *out.mutable_body_intercept()->mutable_face_point());
    case Kind::kGoTo:
      return set_go_to(action, *out.mutable_body_go_to_point());
    case Kind::kTackle:
      return set_tackle(action, *out.mutable_body_tackle_to_point());
    case Kind::kCatch:
      out.mutable_catch_();
      return;
    case Kind::kTurnToBall:
      return out.mutable_body_turn_to_ball()->set_cycle(1);
    case Kind::kTurnTo:
      return set_turn_to(action, *out.mutable_body_turn_to_point());
    case Kind::kMoveTo:
      out.mutable_move()->set_x(action.x);
      return out.mutable_move()->set_y(action.y);
    case Kind::kKickOff:
      return set_point(action, *out.mutable_bhv_before_kick_off()->mutable_point());
    case Kind::kSearchBall:
      out.mutable_bhv_neck_body_to_ball();
      return;
    case Kind::kPenalty:
      out.mutable_helios_penalty();
      return;
    case Kind::kWatchBall:
      out.mutable_neck_turn_to_ball();
      return;
    case Kind::kWatchBallOrScan:
      return out.mutable_neck_turn_to_ball_or_scan()->set_count_threshold(action.count);
    case Kind::kWatchGoalieOrScan:
      out.mutable_neck_turn_to_goalie_or_scan();
      return;
    case Kind::kScan:
      out.mutable_neck_scan_field();
      return;
  }
}

void write(const player::ActionList& list, protos::PlayerActions& actions) {
  // The proxy would place players by its own formation.
  if (list.places_itself) actions.set_ignore_preprocess(true);
  for (const player::TeamAction& action : list.actions()) write(action, *actions.add_actions());
}

}  // namespace

player::Situation situation_of(const protos::State& state) {
  const protos::WorldModel& world = state.world_model();
  player::Situation now;
  now.mode = mode_of(world);
  now.our_set_play = world.is_our_set_play();
  now.set_play_count = world.set_play_count();
  now.offside_line = world.offside_line_x();
  read_self(world.self(), now);
  read_ball(world, now);

  for (const protos::Player& player : world.teammates()) {
    now.teammates.push_back({player.uniform_number(), point_of(player.position()),
                             point_of(player.velocity()), player.pos_count(), player.is_goalie(),
                             player.is_tackling()});
  }

  for (const protos::Player& player : world.opponents()) {
    if (player.pos_count() > player::Situation::kMaxAge) continue;
    now.opponents.push_back(point_of(player.position()));
  }

  return now;
}

void SimpleTeam::decide(const protos::State& state, protos::PlayerActions& actions) const {
  player::ActionList list;
  play_simple_team(situation_of(state), list);
  write(list, actions);
}

void Hold::decide(const protos::State& state, protos::PlayerActions& actions) const {
  player::ActionList list;
  hold_positions(situation_of(state), list);
  write(list, actions);
}

}  // namespace cls::mock_server
