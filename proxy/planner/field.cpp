// Preparation, and who gets at a rolling ball.
#include "proxy/planner/field.h"

#include <algorithm>
#include <cmath>

#include "proxy/skills/kick.h"
#include "proxy/skills/motion.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

using soccer::AngleDeg;
using soccer::Vec2;

// Added to everybody's reach for what is seen inexactly and for the noise of kicks and dashes.
constexpr double kSightError = 0.15;
constexpr int kUnknownTeamAge = 6;
constexpr int kStale = 20;

/// What a player may have run since it was last seen: less and less likely more.
double unseen_run(int age, double speed) {
  double run = 0.0;
  for (int i = 1; i <= std::min(10, age); ++i) {
    run += 0.8 * speed * soccer::math::exp(-i * i / 15.0);
  }
  return run;
}

FieldPlayer field_player(const WorldModel& world, const PlayerState& player,
                         const ReachTable& reach) {
  const soccer::PlayerType& type = world.type_of(player);
  FieldPlayer out;
  out.unum = player.unum;
  out.age = player.pos_count;
  out.goalie = player.goalie;
  out.ghost = player.ghost();
  out.lying = player.tackling;
  out.position = player.position;
  out.velocity = player.velocity_valid() ? player.velocity : Vec2{};
  out.rest = rest_point(out.position, out.velocity, type.player_decay);
  out.body = player.body;
  out.body_known = player.body_count <= 1 + std::min(2, player.pos_count);
  out.control = type.kickable_area(world.server().ball_size);
  out.unseen_run = unseen_run(player.pos_count, reach.settled_speed());
  out.turn_resistance = turn_resistance(type, out.velocity);
  out.type = &type;
  out.reach = &reach;
  return out;
}

/// How far from where he coasts to somebody may have the ball after so many cycles, were he to run
/// at once and straight.
double grasp(const FieldOpponent& opponent, int cycles) {
  return opponent.control + kSightError + opponent.unseen_run + opponent.reach->run(cycles);
}

void prepare(FieldOpponent& opponent, bool in_box_catches, double catch_reach) {
  if (opponent.goalie && in_box_catches) opponent.control = catch_reach;
  for (int cycle = 0; cycle <= kPlannerHorizon; ++cycle) {
    const auto i = static_cast<std::size_t>(cycle);
    opponent.drift[i] =
        coast(opponent.position, opponent.velocity, opponent.type->player_decay, cycle);
    // Somebody on the ground gets up after a while.
    constexpr int kGettingUp = 5;
    const double reach = grasp(opponent, opponent.lying ? cycle - kGettingUp : cycle);
    opponent.grasp2[i] = reach * reach;
  }
}

}  // namespace

PlannerField::PlannerField(const WorldModel& w, int cycles_held) : world(w), held(cycles_held) {
  const double decay = world.server().ball_decay;
  left_[0] = 1.0;
  for (std::size_t i = 1; i < roll_.size(); ++i) {
    left_[i] = left_[i - 1] * decay;
    roll_[i] = roll_[i - 1] + left_[i - 1];
  }
  for (const soccer::PlayerType& type : world.parameters->types) {
    reach_.emplace_back(world.server(), type);
  }
  const auto reach_of = [&](int type) -> const ReachTable& {
    const auto id = static_cast<std::size_t>(std::max(0, type));
    return reach_[id < reach_.size() ? id : 0];
  };
  ball = world.ball.position;
  ball_velocity = world.ball.velocity_valid() ? world.ball.velocity : Vec2{};
  kick_limit = proxy::kick_limit(world);
  open_play =
      world.game.mode == soccer::PlayMode::kPlayOn || soccer::is_penalty_mode(world.game.mode);
  PlayerState me;
  me.unum = world.unum;
  me.goalie = world.goalie;
  me.type_id = world.self.type_id;
  me.position = world.self.position;
  me.velocity = world.self.velocity;
  me.body = world.self.body;
  me.pos_count = me.vel_count = me.body_count = 0;
  self = field_player(world, me, reach_of(me.type_id));
  for (const PlayerState& mate : world.teammates) {
    if (mate.position_valid()) mates.push_back(field_player(world, mate, reach_of(mate.type_id)));
  }
  const double catch_reach = world.server().catchable_area_l;
  const auto add = [&](const PlayerState& player) {
    FieldOpponent opponent;
    static_cast<FieldPlayer&>(opponent) = field_player(world, player, reach_of(player.type_id));
    prepare(opponent, ball.x > 20.0, catch_reach);
    opponents.push_back(opponent);
  };
  for (const PlayerState& player : world.opponents) {
    if (player.pos_count <= kStale && player.ghost_count < 2) add(player);
  }
  for (const PlayerState& player : world.unknowns) {
    if (player.pos_count <= kUnknownTeamAge && !player.ghost()) add(player);
  }
}

int PlannerField::kicks_for(Vec2 direction, double speed) const {
  if (!open_play) return 1;
  const double max = world.server().ball_speed_max;
  if (max_speed_along(ball_velocity, direction, kick_limit, max) >= speed &&
      (direction * speed - ball_velocity).length() <= kick_limit) {
    return 1;
  }
  return speed > 2.5 ? 3 : 2;
}

const FieldPlayer* PlannerField::ours(int unum) const {
  if (unum == self.unum) return &self;
  for (const FieldPlayer& mate : mates) {
    if (mate.unum == unum) return &mate;
  }
  return nullptr;
}

int turns_to_face(const FieldPlayer& player, Vec2 way, double slack_deg) {
  if (!player.body_known) return 1;
  const double error = (AngleDeg::of(way) - player.body).abs();
  constexpr double kMaxMoment = 180.0;
  const double turn = kMaxMoment / player.turn_resistance;
  if (error <= slack_deg) return 0;
  return error - slack_deg <= turn ? 1 : 2;
}

int cycles_to_get(const FieldPlayer& player, Vec2 point) {
  const Vec2 way = point - player.rest;
  const double dist = way.length();
  const double run = dist - player.control;
  if (run <= 0.0) return 0;
  const double slack =
      std::max(15.0, soccer::math::to_degrees(soccer::math::asin(player.control / dist)));
  constexpr int kGettingUp = 5;
  return turns_to_face(player, way, slack) + player.reach->cycles(run) +
         (player.lying ? kGettingUp : 0);
}

int opponents_cycles_to(const PlannerField& field, Vec2 point, bool count_age) {
  int least = kNever;
  for (const FieldOpponent& opponent : field.opponents) {
    const int age = count_age ? std::min(opponent.age, 5) : 0;
    least = std::min(least, std::max(0, cycles_to_get(opponent, point) - age));
  }
  return least;
}

double nearest_opponent(const PlannerField& field, Vec2 point) {
  double least = 1000.0 * 1000.0;
  for (const FieldOpponent& opponent : field.opponents) {
    least = std::min(least, squared_distance(opponent.position, point));
  }
  return std::sqrt(least);
}

bool is_stopped(const PlannerField& field, const BallRoll& roll, const StopRules& rules) {
  const Vec2 step = roll.direction * roll.speed;
  const double length = roll.speed * field.roll(roll.cycles);
  for (const FieldOpponent& opponent : field.opponents) {
    const auto last =
        static_cast<std::size_t>(std::min(kPlannerHorizon, roll.cycles + rules.head_start));
    // Farther from the whole way than he can come by its end: out of the question.
    const Vec2 relative = opponent.drift[last] - field.ball;
    const double along = std::clamp(dot(relative, roll.direction), 0.0, length);
    const double off2 = (relative - roll.direction * along).squared_length();
    const double allowance = opponent.velocity.length() * 2.0 + rules.extra_reach;
    const double far = std::sqrt(opponent.grasp2[last]) + allowance;
    if (off2 > far * far) continue;
    for (int cycle = 1; cycle <= roll.cycles; ++cycle) {
      const int now = std::min(kPlannerHorizon, cycle + rules.head_start);
      const auto i = static_cast<std::size_t>(now);
      const Vec2 ball = field.ball + step * field.roll(cycle);
      const Vec2 way = ball - opponent.drift[i];
      const double extra = rules.extra_reach;
      const double dist2 = way.squared_length();
      const double reach = std::sqrt(opponent.grasp2[i]) + extra;
      if (dist2 > reach * reach) continue;
      // In reach for one who looks that way; a turn costs others a cycle or two.
      const double dist = std::sqrt(dist2);
      const double unseen = rules.count_age ? opponent.unseen_run : 0.0;
      const double run = dist - opponent.control - kSightError - unseen - extra;
      if (run <= 0.0) return true;
      const double slack = std::max(20.0, soccer::math::to_degrees(soccer::math::asin(
                                              std::min(1.0, (opponent.control + 0.2) / dist))));
      const int turns = turns_to_face(opponent, way, slack);
      const int credit = rules.count_age ? std::min(3, opponent.age) : 0;
      constexpr int kGettingUp = 5;
      const int needed = turns + opponent.reach->cycles(run) + (opponent.lying ? kGettingUp : 0);
      if (needed <= now + credit) return true;
    }
  }
  return false;
}

}  // namespace cls::proxy
