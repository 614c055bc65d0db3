// Scripted teams.
#include "tests/simulator/scripted_match.h"

#include <bit>
#include <cmath>

#include "simulator/actions/actions.h"
#include "simulator/referee/referee.h"
#include "simulator/step.h"
#include "simulator/world/roster.h"
#include "tests/simulator/stage.h"

namespace cls::tests {
namespace {

using namespace cls::simulator;

Vec2 home_of(const Player& player) {
  if (player.unum == 11) return {45.0 * sign(player.side), 4.0};
  const double x = -40.0 + 16.0 * ((player.unum - 2) / 3);
  const double y = -20.0 + 20.0 * ((player.unum - 2) % 3);
  return {x * sign(player.side), y};
}

Slot nearest_to_ball(const World& world, Side side) {
  Slot best = kNoPlayer;
  for (const Player& player : world.players) {
    if (!player.enabled || player.side != side || player.goalie) continue;
    if (best == kNoPlayer || distance(player.position, world.ball.position) <
                                 distance(world.player(best).position, world.ball.position)) {
      best = player.slot();
    }
  }
  return best;
}

double bearing(const Player& player, Vec2 to) {
  return soccer::math::to_degrees(soccer::math::normalize_radians(
      soccer::direction_radians(to - player.position) - player.body));
}

soccer::PlayerCommand go_to(const Player& player, Vec2 to) {
  const double off = bearing(player, to);
  if (std::fabs(off) > 20.0) return soccer::Turn{off};
  return soccer::Dash{distance(player.position, to) > 0.7 ? 90.0 : 20.0, off};
}

soccer::PlayerCommand decide(const World& world, const Player& player) {
  const Vec2 goal = {52.5 * sign(player.side), 6.0 * soccer::math::sin(world.clock.time * 0.37)};
  const double to_ball = distance(player.position, world.ball.position);
  if (player.goalie && to_ball < 1.2 && world.mode == PlayMode::kPlayOn) {
    return soccer::Catch{bearing(player, world.ball.position)};
  }

  if (is_kickable(world, player)) return soccer::Kick{70.0, bearing(player, goal)};
  const Vec2 ball_soon = world.ball.position + world.ball.velocity;
  if (player.goalie) {
    if (to_ball < 12.0) return go_to(player, ball_soon);
    return go_to(player, {-50.0 * sign(player.side), world.ball.position.y * 0.15});
  }

  if (player.slot() == nearest_to_ball(world, player.side)) {
    if (to_ball < 1.8 && world.clock.time % 3 == 0) {
      return soccer::Tackle{0.0, world.clock.time % 2 == 0};
    }
    return go_to(player, ball_soon);
  }

  // Player 11 waits in front of the opponent goal.
  const double with_ball = player.unum == 11 ? 0.0 : 0.6;
  return go_to(player, home_of(player) + world.ball.position * with_ball);
}

void add(std::uint64_t& hash, std::uint64_t value) {
  hash = (hash ^ value) * 0x100000001B3ULL;
  hash ^= hash >> 29;
}
void add(std::uint64_t& hash, double value) { add(hash, std::bit_cast<std::uint64_t>(value)); }
void add(std::uint64_t& hash, Vec2 value) {
  add(hash, value.x);
  add(hash, value.y);
}

}  // namespace

World full_match(const soccer::ServerParams& server, std::uint64_t seed) {
  World world = make_match(server, {}, seed);
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    for (const Side side : {Side::kLeft, Side::kRight}) {
      Player& player = world.player(join(world, side, unum == 1, 19).value());
      player.position = home_of(player);
    }
  }
  return world;
}

void play_cycle(World& world, Events& events) {
  if (world.mode == PlayMode::kBeforeKickOff) kick_off(world, events);
  for (Slot i = 0; i < soccer::kPlayersOnPitch; ++i) {
    // Sides alternate in acting first.
    const Slot slot =
        (i + (world.clock.time % 2) * soccer::kPlayersPerTeam) % soccer::kPlayersOnPitch;
    if (!world.player(slot).enabled) continue;
    apply(world, slot, decide(world, world.player(slot)), events);
  }
  simulator::step(world, events);
  finish_step(world, events);
}

std::uint64_t fingerprint(const World& world) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  add(hash, static_cast<std::uint64_t>(world.clock.time * 1000 + world.clock.stoppage));
  add(hash, static_cast<std::uint64_t>(world.mode));
  add(hash, world.ball.position);
  add(hash, world.ball.velocity);

  for (const Player& player : world.players) {
    add(hash, player.position);
    add(hash, player.velocity);
    add(hash, player.body);
    add(hash, player.stamina.value);
    add(hash, static_cast<std::uint64_t>(player.state));
    add(hash, static_cast<std::uint64_t>(player.counters.kick + 1000 * player.counters.dash));
  }

  RandomStreams random = world.random;
  add(hash, random.ball_motion.next());
  add(hash, random.foul[3].next());
  return hash;
}

}  // namespace cls::tests
