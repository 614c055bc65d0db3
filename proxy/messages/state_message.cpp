// Filling the State: objects, match, teams, lines, intercept table.
#include "proxy/messages/state_message.h"

#include <initializer_list>
#include <string>

#include "base/index.h"
#include "player/world/motion.h"
#include "soccer/angle.h"
#include "soccer/directions.h"
#include "soccer/play_mode.h"

namespace cls::proxy {
namespace {

constexpr float f(double value) { return static_cast<float>(value); }
float degrees(soccer::AngleDeg angle) { return f(angle.degrees()); }
constexpr int wire_unum(int unum) { return unum == 0 ? -1 : unum; }

protos::CardType wire_card(soccer::Card card) {
  return card == soccer::Card::kRed      ? protos::RED
         : card == soccer::Card::kYellow ? protos::YELLOW
                                         : protos::NO_CARD;
}

protos::ViewWidth wire_width(soccer::ViewWidth width) {
  return width == soccer::ViewWidth::kNarrow   ? protos::NARROW
         : width == soccer::ViewWidth::kNormal ? protos::NORMAL
                                               : protos::WIDE;
}

/// Sets the angles of vectors, which cost most of a State, many at a time.
class Angles {
 public:
  Angles() = default;
  Angles(const Angles&) = delete;
  Angles& operator=(const Angles&) = delete;
  ~Angles() { set(); }

  /// `out` has its coordinates. It gets its angle by the next set(), or at the end of this object.
  void add(protos::RpcVector2D& out) {
    if (waiting_.full()) set();
    waiting_.push_back(&out);
  }

  void set() {
    base::FixedList<soccer::Vec2, kBatch> vectors;
    std::array<double, kBatch> degrees;
    for (const protos::RpcVector2D* message : waiting_) {
      vectors.push_back({message->x(), message->y()});
    }
    soccer::directions(vectors.begin(), vectors.size(), degrees.data());
    for (std::size_t i = 0; i < waiting_.size(); ++i) waiting_[i]->set_angle(f(degrees[i]));
    waiting_.clear();
  }

 private:
  static constexpr std::size_t kBatch = 64;
  base::FixedList<protos::RpcVector2D*, kBatch> waiting_;
};

// By reference: a vector passed in two registers is stored as two and loaded as one, which stalls.
void fill_vector(const soccer::Vec2& vector, protos::RpcVector2D& out, Angles& angles) {
  // + 0.0F removes the sign of zero, which would change the direction.
  const float x = f(vector.x) + 0.0F;
  const float y = f(vector.y) + 0.0F;
  // Most of a State equals the previous cycle.
  if (out.x() == x && out.y() == y) return;
  out.set_x(x);
  out.set_y(y);
  out.set_dist(f(soccer::Vec2{x, y}.length()));
  angles.add(out);
}

void copy_vector(const protos::RpcVector2D& from, protos::RpcVector2D& out) {
  out.set_x(from.x());
  out.set_y(from.y());
  out.set_dist(from.dist());
  out.set_angle(from.angle());
}

float angle_from_ball(const player::BallState& ball) {
  return degrees(ball.angle_from_self + 180.0);
}

// Fields that Self and Player have in common, for the agent.
template <typename Message>
void fill_own(const player::WorldModel& world, Message& out) {
  const player::SelfState& self = world.self;
  Angles angles;
  fill_vector(self.position, *out.mutable_position(), angles);
  fill_vector(self.seen_position, *out.mutable_seen_position(), angles);
  fill_vector({}, *out.mutable_heard_position(), angles);
  fill_vector(self.velocity, *out.mutable_velocity(), angles);
  fill_vector(self.seen_velocity, *out.mutable_seen_velocity(), angles);

  out.set_pos_count(self.pos_count);
  out.set_seen_pos_count(self.seen_pos_count);
  out.set_heard_pos_count(player::kNever);
  out.set_vel_count(self.vel_count);
  out.set_seen_vel_count(self.seen_vel_count);
  out.set_ghost_count(0);

  out.set_id(0);
  out.set_side(wire_side(world.our_side));
  out.set_uniform_number(world.unum);
  out.set_uniform_number_count(0);
  out.set_is_goalie(world.goalie);

  out.set_body_direction(degrees(self.body));
  out.set_body_direction_count(self.body_count);
  out.set_face_direction(degrees(self.face()));
  out.set_face_direction_count(self.body_count);
  out.set_point_to_direction(degrees(self.point_direction));
  out.set_point_to_direction_count(self.point_count);

  out.set_is_kicking(self.kicked);
  out.set_dist_from_ball(f(world.ball.dist_from_self));
  out.set_angle_from_ball(angle_from_ball(world.ball));
  out.set_ball_reach_steps(world.intercept.best_self_steps());
  out.set_is_tackling(self.tackling());
  out.set_type_id(self.type_id);
}

}  // namespace

protos::Side wire_side(soccer::Side side) {
  return side == soccer::Side::kLeft    ? protos::LEFT
         : side == soccer::Side::kRight ? protos::RIGHT
                                        : protos::UNKNOWN;
}

void fill(soccer::Vec2 vector, protos::RpcVector2D& out) {
  Angles angles;
  fill_vector(vector, out, angles);
}

void fill_self(const player::WorldModel& world, protos::Self& out) {
  const player::SelfState& self = world.self;
  fill_own(world, out);
  out.set_relative_neck_direction(degrees(self.neck));
  out.set_stamina(f(self.stamina));
  out.set_is_kickable(self.kickable);
  out.set_catch_probability(f(self.catch_probability));
  out.set_tackle_probability(f(self.tackle_probability));
  out.set_foul_probability(f(self.foul_probability));
  out.set_view_width(wire_width(self.view_width));
  out.set_kick_rate(f(self.kick_rate));
  out.set_recovery(f(self.recovery));
  out.set_stamina_capacity(f(self.capacity));
  out.set_card(wire_card(self.card));
  out.set_catch_time(self.catch_time);
  out.set_effort(f(self.effort));
  out.set_get_safety_dash_power(f(self.safety_dash_power));
}

void fill_self_as_player(const player::WorldModel& world, protos::Player& out) {
  const player::SelfState& self = world.self;
  fill_own(world, out);
  out.set_dist_from_self(0.0F);
  out.set_angle_from_self(0.0F);
  const double decay = world.self_type().player_decay;
  fill(player::rest_point(self.position, self.velocity, decay), *out.mutable_inertia_final_point());
  out.set_body_count(self.body_count);
}

namespace {

// Vectors and ages that players and the ball have in common.
template <typename Object, typename Message>
void fill_common_vectors(const Object& object, Angles& angles, Message& out) {
  fill_vector(object.position, *out.mutable_position(), angles);
  fill_vector(object.seen_position, *out.mutable_seen_position(), angles);
  fill_vector(object.heard_position, *out.mutable_heard_position(), angles);
  fill_vector(object.velocity, *out.mutable_velocity(), angles);
  fill_vector(object.seen_velocity, *out.mutable_seen_velocity(), angles);
}

template <typename Object, typename Message>
void fill_common_numbers(const Object& object, Message& out) {
  out.set_pos_count(object.pos_count);
  out.set_seen_pos_count(object.seen_pos_count);
  out.set_heard_pos_count(object.heard_pos_count);
  out.set_vel_count(object.vel_count);
  out.set_seen_vel_count(object.seen_vel_count);
  out.set_ghost_count(object.ghost_count);
  out.set_dist_from_self(f(object.dist_from_self));
  out.set_angle_from_self(degrees(object.angle_from_self));
}

void fill_player_vectors(const player::PlayerState& player, double decay, Angles& angles,
                         protos::Player& out) {
  fill_common_vectors(player, angles, out);
  fill_vector(player::rest_point(player.position, player.velocity, decay),
              *out.mutable_inertia_final_point(), angles);
}

void copy_player_vectors(const protos::Player& from, protos::Player& out) {
  copy_vector(from.position(), *out.mutable_position());
  copy_vector(from.seen_position(), *out.mutable_seen_position());
  copy_vector(from.heard_position(), *out.mutable_heard_position());
  copy_vector(from.velocity(), *out.mutable_velocity());
  copy_vector(from.seen_velocity(), *out.mutable_seen_velocity());
  copy_vector(from.inertia_final_point(), *out.mutable_inertia_final_point());
}

void fill_player_numbers(const player::PlayerState& player, protos::Player& out) {
  fill_common_numbers(player, out);
  out.set_id(player.id);
  out.set_side(wire_side(player.side));
  out.set_uniform_number(wire_unum(player.unum));
  out.set_uniform_number_count(player.unum_count);
  out.set_is_goalie(player.goalie);

  out.set_body_direction(degrees(player.body));
  out.set_body_direction_count(player.body_count);
  out.set_face_direction(degrees(player.face));
  out.set_face_direction_count(player.face_count);
  out.set_point_to_direction(degrees(player.point_direction));
  out.set_point_to_direction_count(player.point_count);

  out.set_is_kicking(player.kicking);
  out.set_dist_from_ball(f(player.dist_from_ball));
  out.set_angle_from_ball(degrees(player.angle_from_ball));
  out.set_ball_reach_steps(player.ball_reach_steps);
  out.set_is_tackling(player.tackling);
  out.set_type_id(player.type_id);
  out.set_body_count(player.body_count);
}

}  // namespace

void fill_player(const player::PlayerState& player, double decay, protos::Player& out) {
  Angles angles;
  fill_player_vectors(player, decay, angles, out);
  fill_player_numbers(player, out);
}

void fill_ball(const player::BallState& ball, protos::Ball& out) {
  Angles angles;
  fill_common_vectors(ball, angles, out);
  fill_vector(ball.relative_position, *out.mutable_relative_position(), angles);
  fill_vector(ball.heard_velocity, *out.mutable_heard_velocity(), angles);

  fill_common_numbers(ball, out);
  out.set_heard_vel_count(ball.heard_vel_count);
  out.set_lost_count(ball.lost_count);
}

namespace {

// By PlayMode. drop_ball has no GameModeType; play continues in the same cycle.
constexpr auto kWireModes = [] {
  using namespace protos;
  std::array<GameModeType, soccer::kPlayModeCount> modes{};
  std::size_t at = 0;
  const auto add = [&](int variants, std::initializer_list<GameModeType> list) {
    for (const GameModeType mode : list) {
      for (int i = 0; i < variants; ++i) modes[at++] = mode;
    }
  };

  add(1, {BeforeKickOff, BeforeKickOff, TimeOver, PlayOn});
  add(2, {KickOff_, KickIn_, FreeKick_, CornerKick_, GoalKick_, AfterGoal_});
  add(1, {PlayOn});
  add(2, {OffSide_, PenaltyKick_});
  add(1, {FirstHalfOver, Pause, Human});
  add(2, {FoulCharge_, FoulPush_, FoulMultipleAttacker_, FoulBallOut_, BackPass_, FreeKickFault_,
          CatchFault_, IndFreeKick_, PenaltySetup_, PenaltyReady_, PenaltyTaken_, PenaltyMiss_,
          PenaltyScore_, IllegalDefense_});
  return modes;
}();
static_assert(kWireModes.back() == protos::IllegalDefense_);

protos::GameModeType wire_mode_of(const player::GameState& game) {
  return game.goalie_catch ? protos::GoalieCatch_ : wire_mode(game.mode);
}

void assign(std::string_view text, std::string* out) {
  if (*out != text) out->assign(text);
}

// By InterceptPlan::Kind.
constexpr std::array kPlanKinds = {protos::OMNI_DASH, protos::TURN_FORWARD_DASH,
                                   protos::TURN_BACKWARD_DASH};

// `value`, the evaluation, stays unset.
void fill_plan(const player::InterceptPlan& plan, Angles& angles, protos::InterceptInfo& out) {
  out.set_action_type(kPlanKinds.at(base::index(plan.kind)));
  out.set_turn_steps(plan.turns);
  out.set_turn_angle(f(plan.turn_angle));
  out.set_dash_steps(plan.dashes);
  out.set_dash_power(f(plan.dash_power));
  out.set_dash_dir(f(plan.dash_direction));
  fill_vector(plan.self_position, *out.mutable_final_self_position(), angles);
  out.set_final_ball_dist(f(plan.ball_distance));
  out.set_final_stamina(f(plan.stamina));
}

// The element to fill: an existing one if possible.
template <typename Message>
Message& element(google::protobuf::RepeatedPtrField<Message>& list, int index) {
  return index < list.size() ? *list.Mutable(index) : *list.Add();
}

template <typename Message>
void shrink(google::protobuf::RepeatedPtrField<Message>& list, int size) {
  while (list.size() > size) list.RemoveLast();
}

void fill_intercept(const player::InterceptTable& table, protos::InterceptTable& out) {
  out.set_self_reach_steps(table.self_steps);
  out.set_first_teammate_reach_steps(table.first_teammate_steps);
  out.set_second_teammate_reach_steps(table.second_teammate_steps);
  out.set_first_opponent_reach_steps(table.first_opponent_steps);
  out.set_second_opponent_reach_steps(table.second_opponent_steps);
  out.set_first_teammate_id(table.first_teammate_id);
  out.set_second_teammate_id(table.second_teammate_id);
  out.set_first_opponent_id(table.first_opponent_id);
  out.set_second_opponent_id(table.second_opponent_id);

  auto& plans = *out.mutable_self_intercept_info();
  int count = 0;
  Angles angles;
  for (const player::InterceptPlan& plan : table.plans) {
    fill_plan(plan, angles, element(plans, count++));
  }
  shrink(plans, count);
}

using PlayerMessages = google::protobuf::RepeatedPtrField<protos::Player>;
using PlayerMap = google::protobuf::Map<google::protobuf::int32, protos::Player>;

// Keys of a team's dictionary: uniform numbers, and -1, -2, ... for unknown ones.
constexpr int kMaxKey = 22;

// Removes entries of earlier cycles; `filled` marks current keys, shifted by kMaxKey.
void remove_stale(const std::array<bool, 2 * kMaxKey + 1>& filled, PlayerMap& map) {
  for (auto entry = map.begin(); entry != map.end();) {
    const bool current = filled[base::index(entry->first + kMaxKey)];
    entry = current ? std::next(entry) : map.erase(entry);
  }
}

// A player and its filled entry in the dictionary.
struct Numbered {
  const player::PlayerState* player;
  const protos::Player* keyed;
};

// Players with a known uniform number go into list and dictionary, others into the dictionary only.
// `with_self` adds the agent to the dictionary.
void fill_team(const player::WorldModel& world, const player::PlayerList& players, bool with_self,
               PlayerMessages& list, PlayerMap& map) {
  std::array<bool, 2 * kMaxKey + 1> filled{};
  const auto entry = [&](int key) -> protos::Player& {
    filled[base::index(key + kMaxKey)] = true;
    return map[key];
  };

  base::FixedList<Numbered, player::PlayerList::capacity()> numbered;
  int unnumbered = 0;
  Angles angles;
  for (const player::PlayerState& player : players) {
    if (!player.position_valid()) continue;
    protos::Player& keyed = entry(player.unum != 0 ? player.unum : --unnumbered);
    fill_player_vectors(player, world.type_of(player).player_decay, angles, keyed);
    fill_player_numbers(player, keyed);
    if (player.unum != 0) numbered.push_back({&player, &keyed});
  }
  angles.set();

  int count = 0;
  for (const Numbered& one : numbered) {
    protos::Player& listed = element(list, count++);
    copy_player_vectors(*one.keyed, listed);
    fill_player_numbers(*one.player, listed);
  }
  shrink(list, count);

  if (with_self) fill_self_as_player(world, entry(world.unum));
  remove_stale(filled, map);
}

void fill_unknowns(const player::WorldModel& world, PlayerMessages& list) {
  int count = 0;
  for (const player::PlayerState& player : world.unknowns) {
    if (!player.position_valid()) continue;
    fill_player(player, world.type_of(player).player_decay, element(list, count++));
  }
  shrink(list, count);
}

void fill_home(const HomePositions& home, protos::WorldModel& out) {
  auto& map = *out.mutable_helios_home_positions();
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    const soccer::Vec2 point = home[base::index(unum - 1)];
    protos::RpcVector2D& entry = map[unum];
    entry.set_x(f(point.x));
    entry.set_y(f(point.y));
  }
}

void fill_penalty(const player::WorldModel& world, protos::WorldModel& out) {
  if (!soccer::is_penalty_mode(world.game.mode)) {
    out.clear_penalty_kick_state();
    return;
  }

  const player::PenaltyState& penalty = world.game.penalty;
  protos::PenaltyKickState& state = *out.mutable_penalty_kick_state();
  state.set_on_field_side(wire_side(penalty.field_side));
  state.set_current_taker_side(wire_side(penalty.taker));
  state.set_our_taker_counter(penalty.our_taken);
  state.set_their_taker_counter(penalty.their_taken);
  state.set_our_score(penalty.our_score);
  state.set_their_score(penalty.their_score);
  state.set_is_kick_taker(penalty.taker == world.our_side &&
                          world.unum == player::default_penalty_taker(penalty.our_taken));
  state.set_cycle(penalty.cycle);
}

void fill_game(const player::WorldModel& world, protos::WorldModel& out) {
  const player::GameState& game = world.game;
  out.set_cycle(game.time.cycle);
  out.set_time_stopped(game.time.stopped);
  out.set_see_time(game.see_time);
  out.set_game_mode_type(wire_mode_of(game));
  out.set_game_mode_side(wire_side(game.mode_side()));
  out.set_stoped_cycle(game.mode_start.stopped);
  out.set_last_set_play_start_time(game.last_set_play_start);
  out.set_set_play_count(game.set_play_count);
  out.set_is_our_set_play(is_set_play_of(game, world.our_side));
  out.set_is_their_set_play(is_set_play_of(game, world.their_side()));
  out.set_is_penalty_kick_mode(soccer::is_penalty_mode(game.mode));

  const bool left = world.our_side == soccer::Side::kLeft;
  out.set_our_team_score(game.our_score);
  out.set_their_team_score(game.their_score);
  out.set_left_team_score(left ? game.our_score : game.their_score);
  out.set_right_team_score(left ? game.their_score : game.our_score);
  out.set_last_kick_side(wire_side(world.last_kick.side));
  out.set_last_kicker_uniform_number(wire_unum(world.last_kick.unum));
  fill_penalty(world, out);
}

void fill_lines(const player::TeamLines& lines, protos::WorldModel& out) {
  out.set_offside_line_x(f(lines.offside));
  out.set_ofside_line_x_count(lines.offside_count);
  out.set_our_defense_line_x(lines.our_defense);
  out.set_their_defense_line_x(lines.their_defense);
  out.set_our_defense_player_line_x(lines.our_defense_players);
  out.set_their_defense_player_line_x(lines.their_defense_players);
}

void fill_teams(const player::WorldModel& world, protos::WorldModel& out) {
  assign(world.our_team_name.view(), out.mutable_our_team_name());
  assign(world.their_team_name.view(), out.mutable_their_team_name());
  out.set_our_side(wire_side(world.our_side));
  out.set_our_goalie_uniform_number(wire_unum(world.our_goalie_unum));
  out.set_their_goalie_uniform_number(wire_unum(world.their_goalie_unum));

  out.set_kickable_teammate_id(world.kickable_teammate_id);
  out.set_kickable_opponent_id(world.kickable_opponent_id);
  out.set_kickable_teammate_existance(world.kickable_teammate());
  out.set_kickable_opponent_existance(world.kickable_opponent());

  fill_team(world, world.teammates, !world.sideline, *out.mutable_teammates(),
            *out.mutable_our_players_dict());
  fill_team(world, world.opponents, false, *out.mutable_opponents(),
            *out.mutable_their_players_dict());
  fill_unknowns(world, *out.mutable_unknowns());
}

}  // namespace

protos::GameModeType wire_mode(soccer::PlayMode mode) { return kWireModes.at(base::index(mode)); }

void fill_coach_state(const player::WorldModel& world, soccer::CoachRole role, protos::State& out) {
  protos::WorldModel& model = *out.mutable_world_model();
  fill_ball(world.ball, *model.mutable_ball());
  fill_teams(world, model);
  fill_game(world, model);
  fill_lines(world.lines, model);
  if (role == soccer::CoachRole::kTrainer) model.set_our_side(protos::UNKNOWN);
}

void fill_state(const player::WorldModel& world, const HomePositions& home, bool need_preprocess,
                protos::State& out) {
  out.set_need_preprocess(need_preprocess);
  protos::WorldModel& model = *out.mutable_world_model();
  fill_self(world, *model.mutable_self());
  fill_ball(world.ball, *model.mutable_ball());
  fill_intercept(world.intercept, *model.mutable_intercept_table());
  fill_teams(world, model);
  fill_game(world, model);
  fill_lines(world.lines, model);
  fill_home(home, model);
}

}  // namespace cls::proxy
