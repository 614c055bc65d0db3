// Computes off-ball positions: blocking, marking and support.
#include "player/movement/off_ball.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/index.h"
#include "player/movement/movement_parameters.h"
#include "player/world/candidates.h"
#include "player/world/motion.h"
#include "player/world/places.h"
#include "player/world/planner_parameters.h"

namespace cls::player {
namespace {

// Blocking.

constexpr int kMaxBlockCycles = 30;  ///< cycles
constexpr double kInTheWay = 0.7;    ///< lateral distance that still blocks, meters

/// Cycles until an opponent has the ball, and the ball position then; empty if no opponent gets it.
struct Possession {
  int cycles = 0;
  Vec2 ball;
};

std::optional<Possession> possession_of_opponents(const WorldModel& world) {
  const InterceptTable& table = world.intercept;
  if (world.kickable_teammate() || world.self.kickable) return std::nullopt;
  if (world.kickable_opponent()) return Possession{0, world.ball.position};
  if (table.first_opponent_steps >= std::min(table.our_steps(), 50)) return std::nullopt;
  return Possession{table.first_opponent_steps, ball_after(world, table.first_opponent_steps)};
}

/// Expected dribble direction: toward our goal, on the wing straight ahead first.
Vec2 dribble_direction(Vec2 ball) {
  const Vec2 goal{-soccer::kHalfLength, std::clamp(ball.y, -5.0, 5.0)};
  Vec2 aim = goal;
  if (ball.x > -30.0) aim = {ball.x - 20.0, 0.85 * ball.y};
  return soccer::with_length(aim - ball, 1.0);
}

/// First cycle in which a player starting at `from` blocks the dribble; kMaxBlockCycles + 1: never.
int cycles_to_block(const WorldModel& world, const soccer::PlayerType& type, Vec2 from,
                    AngleDeg body, bool body_known, const Possession& possession) {
  const Vec2 step = dribble_direction(possession.ball) * world.planner->block_speed;
  for (int cycle = 1; cycle <= kMaxBlockCycles; ++cycle) {
    const Vec2 there = possession.ball + step * std::max(0, cycle - possession.cycles);

    const Vec2 way = there - from;
    const double run = way.length() - kInTheWay;
    if (run <= 0.0) return cycle;
    const bool turn = body_known && (AngleDeg::of(way) - body).abs() > 25.0;
    if (cycles_to_run(world.server(), type, run) + (turn ? 1 : 0) <= cycle) return cycle;
  }

  return kMaxBlockCycles + 1;
}

// Marking.

constexpr int kMaxMarkAge = 12;

bool their_attack(const WorldModel& world) {
  const bool their_set_play = is_set_play_of(world.game, world.their_side());
  return (opponents_are_first(world) || their_set_play) &&
         first_reach_point(world).x < world.planner->mark_ball_x;
}

/// Marking cost: weighted distance of a teammate's position and home position to the opponent.
double marking_cost(const WorldModel& world, int unum, Vec2 home, Vec2 opponent) {
  constexpr double kHomeShare = 0.4;
  const PlayerState* teammate = unum == world.unum ? nullptr : world.teammate(unum);
  Vec2 here = unum == world.unum ? world.self.position : home;
  if (teammate != nullptr && teammate->pos_count <= kMaxMarkAge) here = teammate->position;
  return (1.0 - kHomeShare) * distance(here, opponent) + kHomeShare * distance(home, opponent);
}

// Support.

constexpr SupportParameters kNumbers = kMovement.support;
constexpr std::array<double, 4> kRings{0.0, 2.5, 5.0, 7.5};
constexpr int kDirections = 12;
constexpr int kMaxSupportAge = 10;

bool teammate_has_ball(const WorldModel& world) {
  const InterceptTable& table = world.intercept;
  return world.kickable_teammate() ||
         (table.first_teammate_steps <= 4 &&
          table.first_teammate_steps <
              std::min(table.first_opponent_steps, table.best_self_steps()));
}

/// Distance in meters by which the nearest opponent misses a pass to the point; at most `limit`.
double lane_margin(const WorldModel& world, Vec2 ball, Vec2 point, double limit) {
  constexpr double kPassSpeed = 1.9;
  constexpr double kReaction = 1.5;  // cycles
  constexpr double kRun = 0.7;       // meters per cycle
  const Vec2 way = point - ball;
  const double length = std::max(0.1, way.length());
  double margin = limit;

  for (const PlayerState& opponent : world.opponents) {
    if (opponent.pos_count > kMaxSupportAge || opponent.ghost()) continue;
    const Vec2 relative = opponent.position - ball;
    const double along = std::clamp(dot(relative, way) / length, 0.0, length);
    if (along < 0.5) continue;  // behind the ball
    const double beside = (relative - way * (along / length)).length();
    const double run = kRun * std::max(0.0, along / kPassSpeed - kReaction);
    margin = std::min(margin, beside - 1.0 - run);
  }

  return margin;
}

double free_space(const WorldModel& world, Vec2 point, double limit) {
  double room = limit;
  for (const PlayerState& opponent : world.opponents) {
    if (opponent.pos_count > kMaxSupportAge || opponent.ghost()) continue;
    room = std::min(room, distance(opponent.position, point));
  }
  return room;
}

/// Penalty for points near the home positions of teammates.
double crowding(const WorldModel& world, const TeamPoints& home, Vec2 point) {
  double least = kNumbers.apart;
  for (int unum = 2; unum <= soccer::kPlayersPerTeam; ++unum) {
    if (unum == world.unum) continue;
    least = std::min(least, distance(home[base::index(unum - 1)], point));
  }
  return kNumbers.apart - least;
}

double support_score(const WorldModel& world, const TeamPoints& home, Vec2 ball, Vec2 own,
                     Vec2 point) {
  return kNumbers.lane * lane_margin(world, ball, point, kNumbers.max_lane) +
         kNumbers.room * free_space(world, point, kNumbers.max_room) -
         kNumbers.goal * distance(point, kOpponentGoal) - kNumbers.home * distance(point, own) -
         kNumbers.way * distance(point, world.self.position) -
         kNumbers.crowd * crowding(world, home, point);
}

}  // namespace

bool opponents_are_first(const WorldModel& world) {
  const InterceptTable& table = world.intercept;
  return world.kickable_opponent() || table.first_opponent_steps < table.our_steps();
}

std::optional<Vec2> block_point(const WorldModel& world) {
  const std::optional<Possession> possession = possession_of_opponents(world);
  if (!possession) return std::nullopt;

  const Vec2 here = self_after(world, 1);
  const int own =
      cycles_to_block(world, world.self_type(), here, world.self.body, true, *possession);
  if (own > kMaxBlockCycles) return std::nullopt;

  for (const PlayerState& teammate : world.teammates) {
    if (teammate.goalie || teammate.ghost() || teammate.pos_count > 10 || teammate.tackling) {
      continue;
    }
    const Vec2 from = teammate.position + teammate.known_velocity();
    const int other = cycles_to_block(world, world.type_of(teammate), from, teammate.body,
                                      teammate.body_count <= 2, *possession);
    const bool by_number = other == own && teammate.unum != 0 && teammate.unum < world.unum;
    if (other < own || by_number) return std::nullopt;
  }

  const Vec2 step = dribble_direction(possession->ball) * world.planner->block_speed;
  return possession->ball + step * std::max(0, own - possession->cycles);
}

MarkRules marking_in_open_play(const WorldModel& world) {
  const PlannerParameters& parameters = *world.planner;
  return {parameters.mark_range, parameters.mark_way, parameters.mark_step};
}

std::optional<Mark> find_mark(const WorldModel& world, const TeamPoints& home,
                              const MarkRules& rules) {
  if (!their_attack(world) || world.goalie) return std::nullopt;
  const Vec2 ball = first_reach_point(world);

  base::FixedList<const PlayerState*, 22> attackers;
  for (const PlayerState& opponent : world.opponents) {
    constexpr double kHasBall = 2.5;
    if (opponent.goalie || opponent.ghost() || opponent.pos_count > kMaxMarkAge) continue;
    if (distance(opponent.position, kOwnGoal) > rules.near_goal) continue;
    if (distance(opponent.position, ball) < kHasBall) continue;
    attackers.push_back(&opponent);
  }

  // Those at the same distance keep the order of the list that they point into.
  std::ranges::sort(attackers, {}, [](const PlayerState* attacker) {
    return std::pair(distance(attacker->position, kOwnGoal), attacker);
  });

  std::array<bool, soccer::kPlayersPerTeam> taken{};
  for (const PlayerState* attacker : attackers) {
    constexpr double kNear = 35.0;
    const bool near = distance(attacker->position, kOwnGoal) < kNear;
    Lowest<int> marker{near ? std::max(rules.max_cost, rules.max_cost_near_goal) : rules.max_cost};
    for (int unum = 2; unum <= soccer::kPlayersPerTeam; ++unum) {
      const std::size_t i = base::index(unum - 1);
      if (taken[i] || unum == world.our_goalie_unum) continue;
      marker.offer(marking_cost(world, unum, home[i], attacker->position), unum);
    }

    if (marker.value == 0) continue;
    taken[base::index(marker.value - 1)] = true;
    if (marker.value != world.unum) continue;

    const Vec2 there =
        attacker->position + (attacker->velocity_valid() ? attacker->velocity * 2.0 : Vec2{});
    return Mark{there + soccer::with_length(kOwnGoal - there, rules.step), attacker};
  }

  return std::nullopt;
}

std::optional<Vec2> support_point(const WorldModel& world, const TeamPoints& home) {
  const PlannerParameters& parameters = *world.planner;
  const Vec2 ball = first_reach_point(world);
  const Vec2 own = home[base::index(world.unum - 1)];
  if (world.goalie || !teammate_has_ball(world) || ball.x < parameters.support_ball_x ||
      distance(own, ball) > parameters.support_distance || own.x < ball.x - 12.0 ||
      world.self.stamina < parameters.support_stamina * world.server().stamina_max) {
    return std::nullopt;
  }

  Highest<Vec2> best{-1e9, own};
  for (const double ring : kRings) {
    for (int i = 0; i < (ring > 0.0 ? kDirections : 1); ++i) {
      Vec2 point = own + soccer::polar_degrees(ring, 360.0 * i / kDirections);
      point.x = std::min({point.x, world.lines.offside - 0.7, soccer::kHalfLength - 1.5});
      point.y = std::clamp(point.y, -soccer::kHalfWidth + 1.5, soccer::kHalfWidth - 1.5);

      if (distance(point, ball) < 5.0) continue;
      best.offer(support_score(world, home, ball, own, point), point);
    }
  }

  return best.value;
}

}  // namespace cls::player
