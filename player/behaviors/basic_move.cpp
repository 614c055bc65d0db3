// Decides the move of a player without the ball.
#include "player/behaviors/behaviors.h"

#include <algorithm>
#include <optional>

#include "base/index.h"
#include "player/behaviors/behavior_parameters.h"
#include "player/movement/home_positions.h"
#include "player/movement/movement.h"
#include "player/movement/off_ball.h"
#include "player/world/motion.h"
#include "player/world/places.h"
#include "player/world/planner_parameters.h"
#include "soccer/interval.h"

namespace cls::player {

namespace {

constexpr PaceParameters kNumbers = kBehaviors.pace;

/// True if opponents attack with a ball that is behind the agent, a defender or midfielder.
bool has_been_passed(const WorldModel& world, Vec2 ball) {
  const bool is_back = world.unum >= 2 && world.unum <= 8;
  return is_back && opponents_are_first(world) &&
         ball.x < std::min(kNumbers.chase_x, world.self.position.x);
}

}  // namespace

double running_pace(const WorldModel& world) {
  const soccer::ServerParams& server = world.server();
  const int half = server.half_time_cycles();
  const int cycle = world.game.time.cycle;
  const bool is_limited = server.stamina_capacity > 0.0 && world.self.capacity >= 0.0;
  if (!is_limited || half <= 0 || cycle >= server.normal_time_cycles()) return 1.0;

  const double remaining_time = static_cast<double>(half - cycle % half) / half;
  const double even = (server.stamina_max + server.stamina_capacity) * remaining_time;
  const double ahead = (world.self.stamina + world.self.capacity) / even - 1.0;

  return std::clamp(1.0 + world.planner->pace * ahead, kNumbers.slowest, kNumbers.fastest);
}

double normal_dash_power(const WorldModel& world, bool& recovering) {
  const SelfState& self = world.self;
  const double max = world.server().max_dash_power;
  const double stamina_max = world.server().stamina_max;
  const PlannerParameters& parameters = *world.planner;
  if (self.stamina < parameters.tired_below * stamina_max) recovering = true;
  if (self.stamina > parameters.rested_above * stamina_max) recovering = false;

  const double income = world.self_type().stamina_inc_max * self.recovery;
  const InterceptTable& table = world.intercept;
  const Vec2 ball = first_reach_point(world);

  if (self.capacity == 0.0) return std::min(max, self.stamina + world.self_type().extra_stamina);
  if (self.position.x < world.lines.our_defense &&
      ball.x < world.lines.our_defense + kNumbers.behind_line) {
    return max;
  }
  const bool chases = self.stamina > parameters.chase_stamina * stamina_max;
  if (chases && has_been_passed(world, ball)) return max;
  if (recovering) return std::max(0.0, income - kNumbers.rest);
  if (world.kickable_teammate() && world.ball.dist_from_self < kNumbers.close_ball) {
    return std::min(max, parameters.run_power_near * income);
  }

  if (self.position.x > world.lines.offside) return max;
  if (ball.x > kNumbers.attack_x && ball.x > self.position.x + kNumbers.attack_ahead &&
      table.our_steps() < table.first_opponent_steps - kNumbers.safe_lead) {
    return soccer::between(kNumbers.attack_share * income, kNumbers.attack_power, max);
  }

  return std::min(max, running_pace(world) * parameters.run_power * income);
}

namespace {

bool tackle(ActionContext& c) {
  if (!basic_tackle(c.world, c.slots, c.world.planner->tackle_chance)) return false;
  c.neck.kind = NeckPlan::Kind::kBall;
  return true;
}

bool may_intercept(const WorldModel& world, const ActionMemory& memory) {
  return world.intercept.best_self_steps() < kNever && !must_leave_ball(world, memory);
}

/// True if the ball is the agent's to get.
bool should_intercept(const WorldModel& world, const ActionMemory& memory) {
  const InterceptTable& table = world.intercept;
  const int self = table.best_self_steps();
  const bool ours_to_get =
      self <= 3 || (self <= table.first_teammate_steps && self < table.first_opponent_steps + 3);
  return !world.kickable_teammate() && ours_to_get && may_intercept(world, memory);
}

bool run_to_ball(ActionContext& c) {
  c.neck.kind = NeckPlan::Kind::kOffensiveIntercept;
  return intercept(c.world, c.slots, true, kOpponentGoal);
}

/// Runs to where an opponent with the ball is met.
bool run_to_opponent(ActionContext& c, Vec2 point) {
  c.neck.kind = NeckPlan::Kind::kBall;
  const double max = c.world.server().max_dash_power;
  if (go_to_point(c.world, c.slots, point, 0.4, max, {3, 20.0, true})) return true;
  return turn_to_ball(c.world, c.slots) || c.slots.has_body();
}

bool run_to_support(ActionContext& c, Vec2 point) {
  c.neck.kind = NeckPlan::Kind::kBallOrScan;
  const double power = safe_dash_power(c.world, c.world.server().max_dash_power);
  if (!go_to_point(c.world, c.slots, point, 1.0, power)) turn_to_ball(c.world, c.slots);
  return c.slots.has_body();
}

bool run_to_place(ActionContext& c, Vec2 place, bool marks) {
  const WorldModel& world = c.world;
  const double usual_threshold = std::max(1.0, 0.1 * world.ball.dist_from_self);
  const double threshold = marks ? 0.5 : usual_threshold / std::min(1.0, running_pace(world));
  const double usual = normal_dash_power(world, c.memory.recovering);
  const double power = marks ? world.server().max_dash_power : usual;

  if (!go_to_point(world, c.slots, place, threshold, power)) turn_to_ball(world, c.slots);
  const bool duel = world.kickable_opponent() && world.ball.dist_from_self < 18.0;
  c.neck.kind = duel ? NeckPlan::Kind::kBall : NeckPlan::Kind::kBallOrScan;
  return c.slots.has_body();
}

/// Where the opponent with the ball, or the one who gets it first, will be in a cycle.
std::optional<Vec2> place_of_their_holder(const WorldModel& world) {
  const int holder = world.kickable_opponent_id != 0 ? world.kickable_opponent_id
                                                     : world.intercept.first_opponent_id;
  const PlayerState* opponent = world.player_by_id(holder);
  if (opponent == nullptr) return std::nullopt;
  return opponent->position + opponent->velocity;
}

}  // namespace

bool basic_move(ActionContext& c) {
  const WorldModel& world = c.world;
  if (tackle(c)) return true;
  if (should_intercept(world, c.memory)) return run_to_ball(c);
  if (const std::optional<Vec2> block = block_point(world)) return run_to_opponent(c, *block);

  const TeamPoints homes = home_positions(world);
  if (const auto support = support_point(world, homes)) return run_to_support(c, *support);
  const std::optional<Mark> mark = find_mark(world, homes, marking_in_open_play(world));
  return run_to_place(c, mark ? mark->point : homes[base::index(world.unum - 1)], mark.has_value());
}

Moves moves_of(const WorldModel& world, const ActionMemory& memory) {
  Moves moves;
  CommandSlots unused(world);
  const TeamPoints homes = home_positions(world);
  const std::optional<Mark> mark = find_mark(world, homes, marking_in_open_play(world));

  moves.may_tackle = basic_tackle(world, unused, world.planner->tackle_chance);
  moves.may_intercept = may_intercept(world, memory);
  moves.press = place_of_their_holder(world);
  moves.block = block_point(world);
  moves.support = support_point(world, homes);
  if (mark) moves.mark = mark->point;
  moves.home = homes[base::index(world.unum - 1)];

  moves.usual = moves.may_tackle                  ? MoveKind::kTackle
                : should_intercept(world, memory) ? MoveKind::kIntercept
                : moves.block                     ? MoveKind::kBlock
                : moves.support                   ? MoveKind::kSupport
                : moves.mark                      ? MoveKind::kMark
                                                  : MoveKind::kHome;
  return moves;
}

bool make_move(ActionContext& c, const Moves& moves, MoveKind kind, Vec2 shift) {
  switch (kind) {
    case MoveKind::kTackle:
      return tackle(c);
    case MoveKind::kIntercept:
      return moves.may_intercept && run_to_ball(c);
    case MoveKind::kPress:
      return moves.press && run_to_opponent(c, *moves.press);
    case MoveKind::kBlock:
      return moves.block && run_to_opponent(c, *moves.block);
    case MoveKind::kSupport:
      return moves.support && run_to_support(c, *moves.support);
    case MoveKind::kMark:
      return moves.mark && run_to_place(c, *moves.mark, true);
    case MoveKind::kHome:
      break;
  }
  return run_to_place(c, moves.home + shift, false);
}

}  // namespace cls::player
