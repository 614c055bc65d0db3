// catch: the goalie catches the ball or punches it away (docs/spec/simulation-model.md 4.6).
#include <algorithm>
#include <cmath>

#include "simulator/actions/commands.h"
#include "simulator/referee/collision.h"
#include "simulator/referee/referee.h"
#include "simulator/world/angles.h"
#include "soccer/interval.h"

namespace cls::simulator::actions {
namespace {

namespace math = soccer::math;

/// Reach of the goalie; the x axis is the direction of the catch.
struct CatchArea {
  double reliable_length;
  double length;
  double width;

  bool contains(Vec2 ball) const {
    return ball.x >= 0.0 && ball.x <= length && std::fabs(ball.y) <= width / 2.0;
  }
};

CatchArea catch_area(const soccer::ServerParams& server, const soccer::PlayerType& type) {
  const double stretch = server.catchable_area_l * (type.catchable_area_l_stretch - 1.0);
  return {server.catchable_area_l - stretch, server.catchable_area_l + stretch,
          server.catchable_area_w};
}

bool succeeds(World& world, const Player& player, const CatchArea& area, Vec2 ball) {
  double probability = world.params().catch_probability;
  if (ball.x > area.reliable_length) {
    const double beyond = (ball.x - area.reliable_length) / (area.length - area.reliable_length);
    probability = std::clamp(probability * (1.0 - beyond), 0.0, 1.0);
  }

  const Slot slot = player.slot();
  const bool drawn = world.random.catch_ball[static_cast<std::size_t>(slot)].bernoulli(probability);
  if (!world.overrides) return drawn;
  return world.overrides->catch_ball.replace(slot, drawn, probability < 1.0);
}

// Distance between goalie and ball surfaces; negative if they overlap. During log replay the
// recorded body angle decides the sign where the rounding of the log lost it.
double gap_to_ball(const World& world, const Player& player, Vec2 to_ball) {
  constexpr double kRounding = 3e-4;
  const double gap =
      to_ball.length() - world.params().ball_size - world.type_of(player).player_size;

  if (!world.overrides || std::fabs(gap) > kRounding) return gap;
  const auto body = world.overrides->body[static_cast<std::size_t>(player.slot())];
  if (!body) return gap;

  const double turned = math::normalize_radians(*body - soccer::direction_radians(to_ball));
  return std::fabs(turned) > math::kPi / 2.0 ? -std::fabs(gap) : std::fabs(gap);
}

// Moves the goalie until it touches the ball.
void take_ball(World& world, Player& player, Events& events) {
  const Vec2 to_ball = world.ball.position - player.position;
  const Vec2 move = soccer::with_length(to_ball, gap_to_ball(world, player, to_ball));
  player.position += move;
  player.pending_body = soccer::direction_radians(move);
  player.velocity = {};

  if (!soccer::is_penalty_mode(world.mode)) {
    announce(world, {"goalie_catch_ball", player.side}, events);
  }

  resolve_collisions(world, events);
  on_ball_touched(world, player.slot(), events);
  on_ball_caught(world, player.slot(), events);

  if (world.mode == PlayMode::kFreeKickLeft || world.mode == PlayMode::kFreeKickRight) {
    world.ball_catcher = player.slot();
  }
}

void punch_ball(World& world, Player& player, double direction, Events& events) {
  player.state |= state::kCatchFault;
  const Vec2 velocity = world.ball.velocity;
  Vec2 mirrored = soccer::rotated_radians(velocity, -direction);
  mirrored.x = -mirrored.x;
  mirrored = soccer::rotated_radians(mirrored, direction);
  world.ball.acceleration += mirrored - velocity;

  on_ball_touched(world, player.slot(), events);
  on_ball_punched(world, player.slot(), events);
}

bool may_catch(const World& world, const Player& player) {
  return player.goalie && player.catch_ban == 0 &&
         (world.mode == PlayMode::kPlayOn || soccer::is_penalty_mode(world.mode));
}

}  // namespace

void catch_ball(World& world, Player& player, const soccer::Catch& command, Events& events) {
  if (player.command_done) return;
  const soccer::ServerParams& server = world.params();
  player.command_done = true;
  player.state |= state::kCatch;

  if (!may_catch(world, player)) {
    player.state |= state::kCatchFault;
    return;
  }

  player.catch_ban = server.catch_ban_cycle;
  const double direction =
      player.body + exact_radians(soccer::between(command.direction, server.min_catch_angle,
                                                  server.max_catch_angle));

  const CatchArea area = catch_area(server, world.type_of(player));
  const Vec2 ball = ball_relative_to(world, player, direction);
  if (!area.contains(ball)) {
    player.state |= state::kCatchFault;
    return;
  }

  if (succeeds(world, player, area, ball)) {
    take_ball(world, player, events);
  } else {
    punch_ball(world, player, direction, events);
  }

  ++player.counters.catches;
  player.moves_since_catch = 0;
}

}  // namespace cls::simulator::actions
