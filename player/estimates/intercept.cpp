// Predicts when the other players intercept the ball, and fills the intercept table.
#include "player/estimates/estimates.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/index.h"

namespace cls::player {
namespace {

// Players not seen for longer are ignored.
constexpr int kMaxTeammateAge = 10;
constexpr int kMaxOpponentAge = 15;

/// Cycles a player spends turning before it can run along `offset`.
int turns_needed(const soccer::ServerParams& server, const soccer::PlayerType& type,
                 const PlayerState& player, Vec2 offset, double control) {
  if (player.body_count > player.pos_count + 1) return 0;  // unknown body: assume the best case
  const double distance = offset.length();
  if (distance <= control) return 0;

  const double slack = math::to_degrees(math::asin(control / distance));
  double missing = (AngleDeg::of(offset) - player.body).abs();
  double speed = player.velocity.length();
  int turns = 0;

  while (missing > slack && turns < 5) {
    missing -= server.maxmoment / (1.0 + type.inertia_moment * speed);
    speed *= type.player_decay;
    ++turns;
  }

  return turns;
}

bool table_is_empty(const WorldModel& world) {
  if (world.sideline) return !world.ball.position_valid();
  return world.game.mode == PlayMode::kBeforeKickOff || world.game.mode == PlayMode::kTimeOver ||
         !world.self.position_valid() || !world.ball.position_valid();
}

/// Speed of the ball after cycle `i`; it does not get faster.
double speed_at(const BallPath& path, std::size_t i) {
  return i + 1 < path.size() ? soccer::distance(path[i], path[i + 1]) : 0.0;
}

/// Cycles in which a gap does not close that shrinks by at most `closing` in each; at least 1.
int cycles_apart(double gap, double closing) {
  constexpr double kRounding = 1e-6;
  if (gap >= closing * kInterceptHorizon) return kInterceptHorizon + 1;
  return std::max(1, static_cast<int>((gap - kRounding) / closing));
}

/// Cycles until another player can intercept the ball; kNever beyond the horizon. Assumes the best
/// case for players not seen recently.
int reach_steps(const WorldModel& world, const PlayerState& player, const BallPath& path) {
  const soccer::ServerParams& server = world.server();
  const soccer::PlayerType& type = world.type_of(player);
  const FullRun& run = world.parameters->full_run(player.type_id);
  const double control = type.kickable_area(server.ball_size);

  // It may have run in any direction since it was seen.
  constexpr int kMaxCredit = 10;
  const double credit = 0.5 * run.top_speed * std::min(player.pos_count, kMaxCredit);
  const Vec2 velocity = player.known_velocity();
  const double fastest = run.top_speed + velocity.length();

  for (int n = 0; n <= kInterceptHorizon;) {
    const std::size_t i = base::index(n);
    const Vec2 offset = path[i] - (player.position + velocity * run.drift[i]);
    const double far = run.distance[i] + control + credit;
    const double squared = offset.squared_length();
    if (squared > far * far) {
      n += cycles_apart(std::sqrt(squared) - far, fastest + speed_at(path, i));
      continue;
    }

    const int dashes = n - turns_needed(server, type, player, offset, control);
    const double distance = offset.length() - control - credit;
    if (distance <= 0.0 || (dashes >= 0 && distance <= run.distance[base::index(dashes)])) return n;
    ++n;
  }

  return kNever;
}

/// Cycles and id of a player who gets the ball.
using Rank = std::tuple<int, int>;
constexpr Rank kNoPlayer{kNever, 0};

/// The first and the second player of a team at the ball.
std::array<Rank, 2> rank(const WorldModel& world, PlayerList& players, int kicker_id, int oldest,
                         const BallPath& path) {
  std::array<Rank, 2> ranks{kNoPlayer, kNoPlayer};
  for (PlayerState& player : players) {
    player.ball_reach_steps = kNever;
    if (player.pos_count >= oldest || player.ghost()) continue;
    const int steps = player.id == kicker_id ? 0 : reach_steps(world, player, path);
    player.ball_reach_steps = steps;

    if (steps < std::get<0>(ranks[0])) {
      ranks[1] = std::exchange(ranks[0], {steps, player.id});
    } else if (steps < std::get<0>(ranks[1])) {
      ranks[1] = {steps, player.id};
    }
  }

  return ranks;
}

}  // namespace

BallPath ball_path(const WorldModel& world) {
  BallPath path;
  Vec2 position = world.ball.position;
  Vec2 velocity = world.ball.known_velocity();
  const double decay = world.server().ball_decay;

  for (Vec2& point : path) {
    point = position;
    position += velocity;
    velocity *= decay;
  }
  return path;
}

void update_intercept_table(WorldModel& world, OwnPlans own) {
  InterceptTable& table = world.intercept;
  table.plans.clear();
  std::array<Rank, 2> teammates{kNoPlayer, kNoPlayer};
  std::array<Rank, 2> opponents = teammates;

  if (table_is_empty(world)) {
    table.self_steps = table.self_exhausting_steps = kNever;
    for (PlayerList* list : {&world.teammates, &world.opponents}) {
      for (PlayerState& player : *list) player.ball_reach_steps = kNever;
    }
  } else {
    const BallPath path = ball_path(world);
    opponents = rank(world, world.opponents, world.kickable_opponent_id, kMaxOpponentAge, path);

    BallPath resting;
    resting.fill(world.ball.position);
    teammates = rank(world, world.teammates, world.kickable_teammate_id, kMaxTeammateAge,
                     world.kickable_opponent() ? resting : path);

    const int others = std::min(std::get<0>(teammates[0]), std::get<0>(opponents[0]));
    const int most = own == OwnPlans::kAll ? kInterceptHorizon : others;
    if (!world.sideline) {
      plan_self_intercept(world, path, std::min(most, kInterceptHorizon), table);
    }
  }

  std::tie(table.first_teammate_steps, table.first_teammate_id) = teammates[0];
  std::tie(table.second_teammate_steps, table.second_teammate_id) = teammates[1];
  std::tie(table.first_opponent_steps, table.first_opponent_id) = opponents[0];
  std::tie(table.second_opponent_steps, table.second_opponent_id) = opponents[1];
}

}  // namespace cls::player
