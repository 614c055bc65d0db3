// Keepaway rule: keepers (left) keep the ball from takers (right) in a small area
// (docs/spec/simulation-model.md 10.3).
#include <cmath>

#include "simulator/referee/rule.h"
#include "simulator/world/stamina.h"

namespace cls::simulator {
namespace {

// The takers win the ball after so many cycles in which one of them could kick it.
constexpr int kPossessionCycles = 4;
constexpr double kBallInset = 4.0;
constexpr double kCornerSpread = 3.0;

struct Area {
  double half_length;
  double half_width;
};

Area area_of(const World& world) {
  return {world.params().keepaway_length / 2.0, world.params().keepaway_width / 2.0};
}

Vec2 keeper_position(World& world, int corner) {
  const Area area = area_of(world);
  RandomStream& stream = world.random.placement;

  if (corner > 2) {
    const double x = stream.uniform(-1.0, 1.0);
    return {x, stream.uniform(-1.0, 1.0)};
  }

  const double inset_x = stream.uniform(0.0, kCornerSpread);
  const double inset_y = stream.uniform(0.0, kCornerSpread);
  return {corner == 0 ? -area.half_length + inset_x : area.half_length - inset_x,
          corner == 2 ? area.half_width - inset_y : -area.half_width + inset_y};
}

Vec2 taker_position(World& world) {
  const Area area = area_of(world);
  const double x = world.random.placement.uniform(0.0, kCornerSpread);
  const double y = world.random.placement.uniform(0.0, kCornerSpread);
  return {-area.half_length + x, area.half_width - y};
}

void start_episode(World& world) {
  KeepawayState& state = world.referee.keepaway;
  int corner = world.random.placement.integer(state.keepers);
  for (Player& player : world.players) {
    if (!player.enabled) continue;
    if (player.side == Side::kLeft) {
      player.position = keeper_position(world, corner);
      corner = (corner + 1) % state.keepers;
    } else {
      player.position = taker_position(world);
    }
    player.velocity = {};
  }

  const Area area = area_of(world);
  place_ball(world, world.kick_off_side,
             {-area.half_length + kBallInset, -area.half_width + kBallInset});

  recover_all(world);
  state.possession = 0;
}

void start_game(World& world) {
  KeepawayState& state = world.referee.keepaway;
  for (const Player& player : world.players) {
    if (player.enabled) ++(player.side == Side::kLeft ? state.keepers : state.takers);
  }

  state.episode = 1;
  start_episode(world);
}

void end_episode(World& world, bool won_by_takers, Events& events) {
  announce(world, {"training Keepaway 1"}, events);
  ++world.referee.keepaway.episode;
  start_episode(world);
  if (won_by_takers) world.referee.keepaway.possession = KeepawayState::kWonByTakers;
}

bool is_ball_outside(const World& world) {
  const Area area = area_of(world);
  return std::fabs(world.ball.position.x) >= area.half_length ||
         std::fabs(world.ball.position.y) >= area.half_width;
}

void count_possession(World& world) {
  KeepawayState& state = world.referee.keepaway;
  const soccer::ServerParams& server = world.params();
  const double reach = server.player_size + server.ball_size + server.kickable_margin;
  bool keepers_have_it = false;
  for (const Player& player : world.players) {
    if (!player.enabled || distance(player.position, world.ball.position) > reach) continue;
    keepers_have_it = player.side == Side::kLeft;
    if (keepers_have_it) continue;
    ++state.possession;
    break;
  }
  if (keepers_have_it) state.possession = 0;
}

void analyze(World& world, Events& events) {
  const soccer::ServerParams& server = world.params();
  KeepawayState& state = world.referee.keepaway;
  if (!server.keepaway) return;

  if (state.won_by_takers()) state.possession = 0;
  if (world.mode != PlayMode::kPlayOn) {
    // rcssserver waits in wall-clock seconds; here a second is 1000 / simulator_step steps.
    const int waited = world.clock.time + world.clock.stoppage;
    const bool starts = server.keepaway_start >= 0 &&
                        waited * server.simulator_step >= server.keepaway_start * 1000;
    if (starts) change_mode(world, PlayMode::kPlayOn, events);
  } else if (state.episode == 0) {
    start_game(world);
  } else if (is_ball_outside(world)) {
    end_episode(world, false, events);
  } else if (state.possession >= kPossessionCycles) {
    end_episode(world, true, events);
  } else {
    count_possession(world);
  }
}

}  // namespace

const Rule kKeepawayRule = {.analyze = analyze};

}  // namespace cls::simulator
