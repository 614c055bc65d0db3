// Updates a world model by server messages; estimators are in player/tracking and player/estimates.
#include "player/perception/perception.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/index.h"
#include "player/estimates/estimates.h"
#include "player/perception/partial_update.h"
#include "player/tracking/tracking.h"
#include "player/world/places.h"
#include "soccer/directions.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/protocol/message_kind.h"

namespace cls::player {
namespace {

/// Estimates are advanced by at most this many cycles, one by one: none is of use after that.
constexpr int kMaxLostCycles = 1000;
static_assert(kMaxLostCycles >= kNever);

/// Copy-on-write access: parameters are shared by copies of a world model, and by all new ones.
MatchParameters& mutable_parameters(WorldModel& world) {
  if (world.parameters.use_count() > 1) {
    world.parameters = std::make_shared<MatchParameters>(*world.parameters);
  }
  return const_cast<MatchParameters&>(*world.parameters);
}

void age_self(SelfState& self, int cycles) {
  for (int* age : {&self.pos_count, &self.seen_pos_count, &self.vel_count, &self.seen_vel_count,
                   &self.body_count, &self.point_count}) {
    *age = std::min(kNever, *age + cycles);
  }
}

/// Copies the values of a sense_body message.
void copy_sense_body(WorldModel& world, const soccer::SenseBody& sense) {
  SelfState& self = world.self;
  self.kicked = sense.counts.kick > self.counts.kick;
  self.stamina = sense.stamina;
  self.effort = sense.effort;
  self.capacity = sense.capacity;
  self.counts = sense.counts;

  self.view_width = sense.width;
  self.view_quality = sense.quality;
  self.focus_distance = sense.focus_distance;
  self.focus_direction = AngleDeg(sense.focus_direction);
  self.attention_side = sense.attention_side;
  self.attention_unum = sense.attention_unum;

  self.tackle_count = sense.tackle_count;
  self.tackle_expires_in = sense.tackle_expires_in;
  self.foul_charged = sense.foul_charged;
  self.collided_with_ball = sense.collided_with_ball;
  self.collided_with_player = sense.collided_with_player;
  self.collided_with_post = sense.collided_with_post;
  self.card = sense.card;
}

/// Computes recovery by the server's rules, because sense_body has only stamina and effort.
void update_recovery(WorldModel& world, const soccer::SenseBody& sense, int cycles) {
  SelfState& self = world.self;
  const soccer::ServerParams& server = world.server();
  if (sense.capacity > self.capacity && self.capacity >= 0.0 &&
      sense.stamina >= server.stamina_max) {
    self.recovery = server.recover_init;  // new half or substitution
    return;
  }

  // The rule uses the stamina before the gain of the cycle.
  const double gain =
      sense.capacity == 0.0 ? 0.0 : self.recovery * world.self_type().stamina_inc_max;
  if (sense.stamina - gain > server.recover_dec_thr * server.stamina_max) return;
  self.recovery = std::max(server.recover_min, self.recovery - cycles * server.recover_dec);
}

/// Updates the pointing arm while the server reports it.
void update_arm(WorldModel& world, const soccer::SenseBody& sense) {
  SelfState& self = world.self;

  const bool moved = sense.arm.count > self.arm.count;
  self.arm = sense.arm;
  if (sense.arm.expires_in == 0) {
    self.point_count = kNever;
    return;
  }

  if (moved) self.point_count = 0;
  self.point_direction = self.face() + sense.arm.target_direction;
}

/// Updates the last executed catch and the catch ban after an attempt.
void update_catches(WorldModel& world, const soccer::SenseBody& sense, int cycles) {
  SelfState& self = world.self;
  self.catch_ban = std::max(0, self.catch_ban - cycles);
  if (sense.counts.catches > self.counts.catches) self.catch_time = sense.time;
  const bool tried = world.self_tracker.sent.catches.has_value() && world.goalie;
  if (tried && self.catch_ban == 0) {
    self.catch_ban = std::max(1, world.server().catch_ban_cycle) - 1;
  }
}

void publish_pose(WorldModel& world) {
  const Gaussian<3>& pose = world.self_tracker.pose;
  SelfState& self = world.self;
  self.position = {pose.mean[0], pose.mean[1]};
  self.body = AngleDeg(pose.mean[2]);
  self.position_deviation = std::sqrt(0.5 * (pose.at(0, 0) + pose.at(1, 1)));
  self.body_deviation = std::sqrt(pose.at(2, 2));
}

int type_of_number(const std::array<int, soccer::kPlayersPerTeam>& types, int unum) {
  return unum == 0 ? -1 : types[base::index(unum - 1)];
}

void update_marks(const WorldModel& world, PlayerState& player) {
  const bool our_team = player.side == world.our_side;
  player.type_id = type_of_number(our_team ? world.our_types : world.their_types, player.unum);
  player.kicking = player.kick_count == 0;
  player.tackling = player.tackle_count + 2 <= world.server().tackle_cycles;
}

void update_distances(const WorldModel& world, PlayerList& players) {
  const Vec2 self = world.self.position;
  const Vec2 ball = world.ball.position;
  // From the agent, from the ball.
  base::FixedList<Vec2, 2 * PlayerList::capacity()> vectors;

  for (const PlayerState& player : players) {
    vectors.push_back(player.position - self);
    vectors.push_back(player.position - ball);
  }

  std::array<double, 2 * PlayerList::capacity()> degrees;
  soccer::directions(vectors.begin(), vectors.size(), degrees.data());
  for (std::size_t i = 0; i < players.size(); ++i) {
    PlayerState& player = players[i];
    player.dist_from_self = soccer::distance(player.position, self);
    player.angle_from_self = AngleDeg(degrees[2 * i]);

    if (world.ball.pos_count >= kNever) {
      player.dist_from_ball = kNever;
      continue;
    }

    player.dist_from_ball = soccer::distance(player.position, ball);
    player.angle_from_ball = AngleDeg(degrees[2 * i + 1]);
  }
}

/// Sets distances, marks and types of all players.
void update_players(WorldModel& world) {
  for (PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns}) {
    for (PlayerState& player : *list) update_marks(world, player);
    update_distances(world, *list);
  }
}

void update_ball(WorldModel& world) {
  BallState& ball = world.ball;
  ball.relative_position = ball.position - world.self.position;
  ball.dist_from_self = ball.pos_count < kNever ? ball.relative_position.length() : kNever;
  ball.angle_from_self = AngleDeg::of(ball.relative_position);
}

/// Uniform number of a team's goalie: the player seen with the goalie mark, otherwise `known`.
int goalie_of(const PlayerList& players, int known) {
  const PlayerState* found = std::ranges::find_if(
      players, [](const PlayerState& player) { return player.goalie && player.unum != 0; });
  return found != players.end() ? found->unum : known;
}

/// True if the ball is seen inside the kickable area, but within the safety margin.
bool barely_kickable(const WorldModel& world) {
  if (world.self.kickable || world.ball.seen_pos_count != 0 || world.ball.ghost_count != 0) {
    return false;
  }
  return world.ball.dist_from_self <= world.self_type().kickable_area(world.server().ball_size);
}

/// Sets kickable of a barely kickable ball where waiting is worse: late intercept, near opponent,
/// or the ball leaves the pitch. Needs all own intercept plans.
void relax_kickable(WorldModel& world) {
  const InterceptTable& table = world.intercept;
  constexpr int kLateIntercept = 10;
  const int own = table.best_self_steps();
  const BallPath path = ball_path(world);
  const bool leaves = outside_pitch(path[base::index(std::min(own, kInterceptHorizon))]);
  world.self.kickable = own >= kLateIntercept || table.first_opponent_steps + 2 <= own || leaves;
}

void update_derived(WorldModel& world, OwnPlans own) {
  ++world.game.set_play_count;
  update_ball(world);
  update_players(world);

  if (world.goalie) world.our_goalie_unum = world.unum;
  world.our_goalie_unum = goalie_of(world.teammates, world.our_goalie_unum);
  world.their_goalie_unum = goalie_of(world.opponents, world.their_goalie_unum);

  update_last_kicker(world);
  update_kickable_players(world);
  update_action_probabilities(world);

  const bool relaxes = barely_kickable(world);
  update_intercept_table(world, relaxes ? OwnPlans::kAll : own);
  if (relaxes) relax_kickable(world);
  if (world.intercept.first_opponent_steps > 0) world.self.foul_probability = 0.0;
  update_team_lines(world);
}

}  // namespace

void on_init(WorldModel& world, const soccer::PlayerInitReply& reply, soccer::TeamName team_name,
             bool goalie) {
  world.our_side = reply.side;
  world.unum = reply.unum;
  world.goalie = goalie;
  world.our_team_name = team_name;
  world.game.mode = reply.mode;
}

base::Result<void> on_parameter_message(WorldModel& world, std::string_view message) {
  const auto apply = [&](auto values, const auto& update) {
    base::Result<void> parsed = soccer::parse(message, values);
    if (parsed) update(world, values);
    return parsed;
  };

  switch (soccer::message_kind(message)) {
    case soccer::MessageKind::kServerParam:
      return apply(soccer::ServerParams(), on_server_param);
    case soccer::MessageKind::kPlayerParam:
      return apply(soccer::PlayerParams(), on_player_param);
    default:
      return apply(soccer::default_player_type(world.server()), on_player_type);
  }
}

void on_server_param(WorldModel& world, const soccer::ServerParams& params) {
  MatchParameters& match = mutable_parameters(world);
  match.server = params;
  match.set_type(0, soccer::default_player_type(params));
  for (std::size_t id = 1; id < match.types.size(); ++id) {
    match.full_runs[id] = FullRun(params, match.types[id]);
  }

  match.leg_pushes = LegPushes(params);
  if (params.quantize_step_l != match.landmark_distances.step()) {
    match.landmark_distances = DistanceTable(params.quantize_step_l);
  }
  if (params.quantize_step != match.object_distances.step()) {
    match.object_distances = DistanceTable(params.quantize_step);
  }

  world.self.stamina = params.stamina_max;
  world.self.capacity = params.stamina_capacity;
}

void on_player_param(WorldModel& world, const soccer::PlayerParams& params) {
  mutable_parameters(world).player = params;
}

void on_player_type(WorldModel& world, const soccer::PlayerType& type) {
  constexpr int kMaxTypes = 1000;  // upper bound for any server
  if (type.id < 0 || type.id >= kMaxTypes) return;
  mutable_parameters(world).set_type(type.id, type);
}

void on_gaussian_see(WorldModel& world) { world.self.gaussian_see = true; }

void on_change_player_type(WorldModel& world, const soccer::PlayerTypeChange& change) {
  if (change.unum < 1 || change.unum > soccer::kPlayersPerTeam) return;
  if (change.goalie_side != Side::kNeutral) {
    (change.goalie_side == world.our_side ? world.our_goalie_unum : world.their_goalie_unum) =
        change.unum;
    return;
  }

  if (!change.type) {  // an opponent: the new type is not reported
    world.their_types[base::index(change.unum - 1)] = -1;
    return;
  }

  world.our_types[base::index(change.unum - 1)] = *change.type;
  if (change.unum != world.unum) return;

  // A substitute has full stamina.
  world.self.type_id = *change.type;
  world.self.recovery = 1.0;
  world.self.effort = world.self_type().effort_max;
}

void on_sense_body(WorldModel& world, const soccer::SenseBody& sense) {
  SelfState& self = world.self;
  const int before = world.game.time.cycle;
  begin_step(world.game, sense.time);
  const int cycles = std::clamp(before < 0 ? 1 : sense.time - before, 1, kMaxLostCycles);

  age_self(self, cycles);
  world.ball_tracker.pushed = false;
  advance_ball(world, sense, cycles);
  advance_players(world, cycles);
  advance_self(world, sense, cycles);

  update_recovery(world, sense, cycles);
  update_catches(world, sense, cycles);
  copy_sense_body(world, sense);

  world.self_tracker.sent = {};
  publish_pose(world);
  update_arm(world, sense);
  world.heard.clear();
}

void on_see(WorldModel& world, const soccer::See& see) {
  if (see.time != world.game.time.cycle) return;
  world.game.see_time = see.time;
  world.game.last_see = world.game.time;

  if (localize(world, see)) {
    publish_pose(world);
    SelfState& self = world.self;
    self.seen_position = self.position;
    self.seen_velocity = self.velocity;
    self.pos_count = self.seen_pos_count = self.seen_vel_count = self.body_count = 0;
  }

  if (!world.self_tracker.located) return;
  observe_ball(world, see);
  observe_players(world, see);
}

void on_hear(WorldModel& world, const soccer::Hear& hear) {
  if (hear.sender == soccer::Hear::Sender::kReferee) {
    hear_referee(world, hear.time, hear.text);
  } else {
    hear_message(world, hear);
  }
}

void record_sent_commands(WorldModel& world, const std::vector<soccer::PlayerCommand>& commands) {
  SentCommands& sent = world.self_tracker.sent;
  sent = {};

  for (const soccer::PlayerCommand& command : commands) {
    if (const auto* turn = std::get_if<soccer::Turn>(&command)) sent.turn = *turn;
    if (const auto* dash = std::get_if<soccer::Dash>(&command)) sent.dash = *dash;
    if (const auto* kick = std::get_if<soccer::Kick>(&command)) sent.kick = *kick;
    if (const auto* tackle = std::get_if<soccer::Tackle>(&command)) sent.tackle = *tackle;
    if (const auto* catching = std::get_if<soccer::Catch>(&command)) sent.catches = *catching;
    if (const auto* move = std::get_if<soccer::Move>(&command)) sent.move = *move;
    if (const auto* neck = std::get_if<soccer::TurnNeck>(&command)) sent.turn_neck = *neck;
    if (const auto* arm = std::get_if<soccer::PointTo>(&command)) sent.point_to = *arm;
    if (const auto* legs = std::get_if<soccer::LegDash>(&command)) sent.leg_dash = *legs;
  }
}

void update_derived(WorldModel& world) { update_derived(world, OwnPlans::kAll); }

void update_derived_for_looking(WorldModel& world) { update_derived(world, OwnPlans::kFirst); }

}  // namespace cls::player
