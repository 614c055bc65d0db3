// Prepares players for the planner, and predicts who stops a rolling ball.
#include "player/planner/field.h"

#include <algorithm>
#include <cmath>

#include "base/index.h"
#include "player/ball_skills/ball_skills.h"
#include "player/world/motion.h"
#include "soccer/interval.h"

namespace cls::player {
namespace {

constexpr int kUnknownTeamAge = 6;
constexpr int kGettingUp = 5;  ///< cycles until a player on the ground runs
constexpr int kMaxAge = 20;

/// Distance a player may have run since it was last seen, weighted by likelihood.
double unseen_run(int age, double speed) {
  constexpr int kCycles = 10;
  static const std::array<double, kCycles + 1> likelihood = [] {
    std::array<double, kCycles + 1> table;
    for (int i = 0; i <= kCycles; ++i) table[base::index(i)] = math::exp(-i * i / 15.0);
    return table;
  }();

  double run = 0.0;
  for (int i = 1; i <= std::min(kCycles, age); ++i) run += 0.8 * speed * likelihood[base::index(i)];

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
  out.velocity = player.known_velocity();
  out.rest = rest_point(out.position, out.velocity, type.player_decay);
  out.body = soccer::polar(1.0, player.body);
  out.body_known = player.body_count <= 1 + std::min(2, player.pos_count);
  out.control = type.kickable_area(world.server().ball_size);
  out.unseen_run = unseen_run(player.pos_count, reach.settled_speed());

  constexpr double kMaxMoment = 180.0;
  const double turn = math::to_radians(kMaxMoment / turn_resistance(type, out.velocity));
  out.turn_cos = math::cos(turn);
  out.turn_sin = math::sin(turn);

  out.type = &type;
  out.reach = &reach;
  return out;
}

/// Distance from its coasting position within which an opponent controls the ball after `cycles` of
/// running straight.
double grasp(const FieldOpponent& opponent, double margin, int cycles) {
  return opponent.control + margin + opponent.unseen_run + opponent.reach->run(cycles);
}

void prepare(FieldOpponent& opponent, double margin, bool in_box_catches, double catch_reach) {
  if (opponent.goalie && in_box_catches) opponent.control = catch_reach;
  opponent.speed = opponent.velocity.length();

  for (int cycle = 0; cycle <= kPlannerHorizon; ++cycle) {
    const std::size_t i = base::index(cycle);
    opponent.drift[i] =
        coast(opponent.position, opponent.velocity, opponent.type->player_decay, cycle);
    // A player on the ground starts later.
    opponent.grasp[i] = grasp(opponent, margin, opponent.lying ? cycle - kGettingUp : cycle);
  }
}

constexpr Slack kTwentyDegrees{0.93969262078590838, 0.34202014332566873};

/// Cycles before the player runs along `way`.
int cycles_before_run(const FieldPlayer& player, Vec2 way, double length) {
  return turns_to_face(player, way, length, slack_for(player.control, length, kFifteenDegrees)) +
         (player.lying ? kGettingUp : 0);
}

int age_credit(const PlannerField& field, const FieldPlayer& player, bool count_age) {
  return count_age ? std::min(player.age, field.parameters.opponent_credit) : 0;
}

/// True if `holds` for an opponent. Consecutive candidates are similar: tries the one first for
/// which it held the last time.
template <typename Condition>
bool any_opponent(const PlannerField& field, std::size_t& last, Condition holds) {
  const auto& opponents = field.opponents;
  if (last < opponents.size() && holds(opponents[last])) return true;
  for (std::size_t i = 0; i < opponents.size(); ++i) {
    if (i == last || !holds(opponents[i])) continue;
    last = i;
    return true;
  }

  return false;
}

/// True if the opponent controls the ball in `now` cycles at the end of `way`, as seen from its
/// coasting position. A turn costs one or two cycles.
bool stops_there(const PlannerField& field, const FieldOpponent& opponent, Vec2 way, double length,
                 int now, const StopRules& rules) {
  const double unseen = rules.count_age ? opponent.unseen_run : 0.0;
  const double run =
      length - opponent.control - field.parameters.opponent_margin - unseen - rules.extra_reach;
  if (run <= 0.0) return true;

  constexpr double kArmsLength = 0.2;
  const Slack slack = slack_for(opponent.control + kArmsLength, length, kTwentyDegrees);
  const int turns = turns_to_face(opponent, way, length, slack);

  constexpr int kMaxCredit = 3;
  const int credit = rules.count_age ? std::min(kMaxCredit, opponent.age) : 0;
  return opponent.reach->run(now + credit - turns - (opponent.lying ? kGettingUp : 0)) >= run;
}

bool stops(const PlannerField& field, const BallRoll& roll, const StopRules& rules,
           const FieldOpponent& opponent) {
  const double way_length = roll.speed * field.roll(roll.cycles);

  const auto at = [&](int cycle) {
    return static_cast<std::size_t>(std::min(kPlannerHorizon, cycle + rules.head_start));
  };

  // Quick rejection: the whole path is out of reach.
  const Vec2 relative = opponent.drift[at(roll.cycles)] - field.ball;
  const double along = soccer::between(dot(relative, roll.direction), 0.0, way_length);
  const double far = opponent.grasp[at(roll.cycles)] + opponent.speed * 2.0 + rules.extra_reach;
  if ((relative - roll.direction * along).squared_length() > far * far) return false;

  // Maximum closing speed of ball and opponent; a faulty server may send types that never run.
  const double closing =
      std::max(0.0, roll.speed + opponent.speed + opponent.type->player_speed_max);
  const Vec2 step = roll.direction * roll.speed;

  for (int cycle = 1; cycle <= roll.cycles; ++cycle) {
    const Vec2 way = field.ball + step * field.roll(cycle) - opponent.drift[at(cycle)];
    const double length = way.length();
    const double gap = length - opponent.grasp[at(cycle)] - rules.extra_reach;
    if (gap > 0.0) {
      cycle += static_cast<int>(std::min<double>(gap / closing, kPlannerHorizon));
    } else if (stops_there(field, opponent, way, length, static_cast<int>(at(cycle)), rules)) {
      return true;
    }
  }

  return false;
}

}  // namespace

PlannerField::PlannerField(const WorldModel& w, int cycles_held)
    : world(w), parameters(*w.planner), held(cycles_held) {
  const double decay = world.server().ball_decay;
  left_[0] = 1.0;
  for (std::size_t i = 1; i < roll_.size(); ++i) {
    left_[i] = left_[i - 1] * decay;
    roll_[i] = roll_[i - 1] + left_[i - 1];
  }

  reach_.reserve(world.parameters->types.size());
  for (const soccer::PlayerType& type : world.parameters->types) {
    reach_.emplace_back(world.server(), type);
  }

  const auto reach_of = [&](int type) -> const ReachTable& {
    const std::size_t id = base::index(std::max(0, type));
    return reach_[id < reach_.size() ? id : 0];
  };

  ball = world.ball.position;
  ball_velocity = world.ball.known_velocity();
  kick_limit = player::kick_limit(world);
  open_play = world.game.mode == PlayMode::kPlayOn || soccer::is_penalty_mode(world.game.mode);

  PlayerState me;
  me.unum = world.unum;
  me.goalie = world.goalie;
  me.type_id = world.self.type_id;
  me.position = world.self.position;
  me.velocity = world.self.velocity;
  me.body = world.self.body;
  me.pos_count = me.vel_count = me.body_count = 0;
  self = field_player(world, me, reach_of(me.type_id));

  for (const PlayerState& teammate : world.teammates) {
    if (teammate.position_valid())
      teammates.push_back(field_player(world, teammate, reach_of(teammate.type_id)));
  }

  const double catch_reach = world.server().catchable_area_l;
  const auto add = [&](const PlayerState& player) {
    FieldOpponent opponent;
    static_cast<FieldPlayer&>(opponent) = field_player(world, player, reach_of(player.type_id));
    prepare(opponent, parameters.opponent_margin, ball.x > 20.0, catch_reach);
    opponents.push_back(opponent);
  };

  for (const PlayerState& player : world.opponents) {
    if (player.pos_count <= kMaxAge && player.ghost_count < 2) add(player);
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

const FieldPlayer* PlannerField::our_player(int unum) const {
  if (unum == self.unum) return &self;
  const FieldPlayer* found = std::ranges::find(teammates, unum, &FieldPlayer::unum);
  return found != teammates.end() ? found : nullptr;
}

Slack slack_for(double reach, double distance, const Slack& least) {
  const double sin = std::min(1.0, reach / distance);
  if (sin <= least.sin) return least;
  return {std::sqrt(1.0 - sin * sin), sin};
}

int turns_to_face(const FieldPlayer& player, Vec2 way, double length, const Slack& slack) {
  if (!player.body_known) return 1;
  const double error_cos = dot(way, player.body) / length;
  if (error_cos >= slack.cos) return 0;
  if (player.turn_cos <= -slack.cos) return 1;  // one turn suffices
  return error_cos >= player.turn_cos * slack.cos - player.turn_sin * slack.sin ? 1 : 2;
}

int cycles_to_get(const FieldPlayer& player, Vec2 point) {
  const Vec2 way = point - player.rest;
  const double length = way.length();
  const double run = length - player.control;
  if (run <= 0.0) return 0;
  return cycles_before_run(player, way, length) + player.reach->cycles(run);
}

int opponents_cycles_to(const PlannerField& field, Vec2 point, bool count_age) {
  int least = kNever;
  for (const FieldOpponent& opponent : field.opponents) {
    const int cycles = cycles_to_get(opponent, point) - age_credit(field, opponent, count_age);
    least = std::min(least, std::max(0, cycles));
  }
  return least;
}

bool opponent_gets_there(const PlannerField& field, Vec2 point, int cycles, bool count_age) {
  return any_opponent(field, field.last_arriver, [&](const FieldOpponent& opponent) {
    const int time = cycles + age_credit(field, opponent, count_age);

    const Vec2 way = point - opponent.rest;
    const double far = opponent.control + opponent.reach->run(time);
    const double length2 = way.squared_length();
    if (length2 > far * far) return false;  // out of reach even without a turn

    const double length = std::sqrt(length2);
    const double run = length - opponent.control;
    return run <= 0.0 ||
           opponent.reach->run(time - cycles_before_run(opponent, way, length)) >= run;
  });
}

double nearest_opponent(const PlannerField& field, Vec2 point) {
  double least = 1000.0 * 1000.0;
  for (const FieldOpponent& opponent : field.opponents) {
    least = std::min(least, squared_distance(opponent.position, point));
  }
  return std::sqrt(least);
}

bool is_stopped(const PlannerField& field, const BallRoll& roll, const StopRules& rules) {
  return any_opponent(field, field.last_stopper, [&](const FieldOpponent& opponent) {
    return stops(field, roll, rules, opponent);
  });
}

}  // namespace cls::player
