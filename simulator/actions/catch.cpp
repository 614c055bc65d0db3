// catch: the goalie takes the ball, or punches it away (4.6).
#include <algorithm>
#include <cmath>

#include "simulator/actions/commands.h"
#include "simulator/referee/calls.h"
#include "simulator/referee/collision.h"
#include "simulator/referee/referee.h"
#include "simulator/world/angles.h"

namespace cls::simulator::actions {
namespace {

namespace math = soccer::math;

/// Where the goalie reaches, in a frame that looks in the direction of the catch.
struct CatchArea {
  double sure_length;
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
  if (ball.x > area.sure_length) {
    const double beyond = (ball.x - area.sure_length) / (area.length - area.sure_length);
    probability = std::clamp(probability * (1.0 - beyond), 0.0, 1.0);
  }
  const auto slot = static_cast<std::size_t>(player.slot());
  const bool drawn = world.random.catch_ball[slot].bernoulli(probability);
  if (!world.forced) return drawn;
  if (probability < 1.0) world.forced->catch_drawn.set(slot);
  return world.forced->catch_ball[slot].value_or(drawn);
}

// How far the goalie is from touching the ball; negative if they overlap. Where a record has
// rounded that away, it is for the recorded body to say on which side.
double gap_to_ball(const World& world, const Player& player, Vec2 to_ball) {
  constexpr double kRounding = 3e-4;
  const double gap =
      to_ball.length() - world.params().ball_size - world.type_of(player).player_size;
  if (!world.forced || std::fabs(gap) > kRounding) return gap;
  const auto body = world.forced->body[static_cast<std::size_t>(player.slot())];
  if (!body) return gap;
  const double turned = math::normalize_radians(*body - soccer::direction_radians(to_ball));
  return std::fabs(turned) > math::kPi / 2.0 ? -std::fabs(gap) : std::fabs(gap);
}

// The goalie goes to the ball until they touch; back from it if they overlap.
void take_ball(World& world, Player& player, Events& events) {
  const Vec2 to_ball = world.ball.position - player.position;
  const Vec2 way = soccer::with_length(to_ball, gap_to_ball(world, player, to_ball));
  player.position += way;
  player.pending_body = soccer::direction_radians(way);
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
      player.body +
      exact_radians(std::clamp(command.direction, server.min_catch_angle, server.max_catch_angle));
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
  ++player.counters.catch_ball;
  player.moves_since_catch = 0;
}

}  // namespace cls::simulator::actions
