// Keepaway: keepers (left) hold the ball from takers (right) in a small area (10.3).
#include "simulator/rules/keepaway.h"

#include <cmath>

#include "simulator/referee/calls.h"
#include "simulator/referee/referee.h"
#include "simulator/referee/rule.h"
#include "simulator/world/stamina.h"

namespace cls::simulator {
namespace {

// Takers own the ball when they could kick it in so many cycles.
constexpr int kPossession = 4;

// In place of a count until the next step, when they have ended an episode.
constexpr int kJustTaken = -1;
constexpr double kBallInset = 4.0;
constexpr double kCornerSpread = 3.0;

struct Area {
  double half_length;
  double half_width;
};

Area area_of(const World& world) {
  return {world.params().keepaway_length / 2.0, world.params().keepaway_width / 2.0};
}

Vec2 keeper_place(World& world, int corner) {
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

Vec2 taker_place(World& world) {
  const Area area = area_of(world);
  const double x = world.random.placement.uniform(0.0, kCornerSpread);
  const double y = world.random.placement.uniform(0.0, kCornerSpread);
  return {-area.half_length + x, area.half_width - y};
}

void start_episode(World& world) {
  KeepawayRule& memory = world.referee.keepaway;
  int corner = world.random.placement.integer(memory.keepers);
  for (Player& player : world.players) {
    if (!player.enabled) continue;
    if (player.side == Side::kLeft) {
      player.position = keeper_place(world, corner);
      corner = (corner + 1) % memory.keepers;
    } else {
      player.position = taker_place(world);
    }
    player.velocity = {};
  }
  const Area area = area_of(world);
  place_ball(world, world.kick_off_side,
             {-area.half_length + kBallInset, -area.half_width + kBallInset});
  recover_all(world);
  memory.possession = 0;
}

void begin(World& world) {
  KeepawayRule& memory = world.referee.keepaway;
  for (const Player& player : world.players) {
    if (player.enabled) ++(player.side == Side::kLeft ? memory.keepers : memory.takers);
  }
  memory.episode = 1;
  start_episode(world);
}

void end_episode(World& world, bool taken, Events& events) {
  announce(world, {"training Keepaway 1"}, events);
  ++world.referee.keepaway.episode;
  start_episode(world);
  if (taken) world.referee.keepaway.possession = kJustTaken;
}

bool is_ball_outside(const World& world) {
  const Area area = area_of(world);
  return std::fabs(world.ball.position.x) >= area.half_length ||
         std::fabs(world.ball.position.y) >= area.half_width;
}

void count_possession(World& world) {
  KeepawayRule& memory = world.referee.keepaway;
  const soccer::ServerParams& server = world.params();
  const double reach = server.player_size + server.ball_size + server.kickable_margin;
  bool keepers_have_it = false;
  for (const Player& player : world.players) {
    if (!player.enabled || distance(player.position, world.ball.position) > reach) continue;
    keepers_have_it = player.side == Side::kLeft;
    if (keepers_have_it) continue;
    ++memory.possession;
    break;
  }
  if (keepers_have_it) memory.possession = 0;
}

void analyse(World& world, Events& events) {
  const soccer::ServerParams& server = world.params();
  KeepawayRule& memory = world.referee.keepaway;
  if (!server.keepaway) return;
  if (was_taken(memory)) memory.possession = 0;
  if (world.mode != PlayMode::kPlayOn) {
    // The server waits for real seconds; here a second is as many steps as it should have.
    const int waited = world.clock.time + world.clock.stoppage;
    const bool is_over = server.keepaway_start >= 0 &&
                         waited * server.simulator_step >= server.keepaway_start * 1000;
    if (is_over) change_mode(world, PlayMode::kPlayOn, events);
  } else if (memory.episode == 0) {
    begin(world);
  } else if (is_ball_outside(world)) {
    end_episode(world, false, events);
  } else if (memory.possession >= kPossession) {
    end_episode(world, true, events);
  } else {
    count_possession(world);
  }
}

}  // namespace

bool was_taken(const KeepawayRule& rule) { return rule.possession == kJustTaken; }

const Rule kKeepawayRule = {.analyse = analyse};

}  // namespace cls::simulator
