// Places the ball and the players of a start.
#include "training/episode/start.h"

#include <algorithm>

#include "base/index.h"
#include "simulator/referee/referee.h"
#include "soccer/math.h"
#include "soccer/per_side.h"

namespace cls::training {
namespace {

StartPlayer player_of(const analysis::BookPlayer& at, const analysis::BookStamina& condition) {
  StartPlayer player;
  player.position = at.position;
  player.velocity = at.velocity;
  player.body = soccer::math::to_radians(at.body);
  player.stamina = {condition.stamina, condition.effort, condition.recovery, condition.capacity};
  return player;
}

void put(const StartPlayer& at, simulator::Player& player) {
  player.enabled = at.on_pitch;
  if (at.type >= 0) player.type = at.type;
  player.cards = at.cards;
  if (!player.enabled) {
    player.position = simulator::bench_position(player);
    player.state |= simulator::state::kDiscard;
    return;
  }

  player.position = at.position;
  player.velocity = at.velocity;
  player.acceleration = {};
  player.body = player.pending_body = at.body;
  player.neck = player.pending_neck = at.neck;

  const double capacity = player.stamina.capacity;
  player.stamina = at.stamina;
  if (at.stamina.capacity < 0.0) player.stamina.capacity = capacity;

  player.legs = {};
  player.tackle_cycles = at.tackle_cycles;
  player.foul_cycles = at.foul_cycles;
  player.catch_ban = at.catch_ban;
  player.command_done = at.tackle_cycles > 0 || at.foul_cycles > 0;
}

}  // namespace

Start start_of(const analysis::Situation& situation) {
  Start start;
  start.mode = situation.mode;
  for (const analysis::BookFrame& from : situation.frames) {
    StartFrame& frame = start.frames.emplace_back();
    frame.ball = from.ball;
    frame.ball_velocity = from.ball_velocity;
    for (std::size_t i = 0; i < frame.players.size(); ++i) {
      frame.players[i] = player_of(from.players[i], situation.players[i]);
    }
  }
  return start;
}

void begin_at(const Start& start, const StartFrame& frame, const Cast& cast,
              simulator::World& world, simulator::Events& events) {
  world.clock.time = start.time;
  for (const Side side : soccer::kBothSides) {
    world.team(side).score = start.score[side == Side::kRight ? 1 : 0];
  }

  const int half = world.rules->half_time;
  const int normal_halfs = world.params().nr_normal_halfs;
  if (half > 0) {
    world.referee.time.finished_halves = std::min(start.time / half, normal_halfs - 1);
  }

  show(frame, cast, world);
  if (world.mode != start.mode) {
    simulator::change_mode(world, start.mode, events);
    show(frame, cast, world);  // the new mode clears players from the ball
  }
  world.referee.touch.toucher = start.last_touch;
  world.ball_catcher = start.catcher;
}

void show(const StartFrame& frame, const Cast& cast, simulator::World& world) {
  world.ball = {frame.ball, frame.ball_velocity, {}};
  world.referee.touch.previous_ball = frame.ball;
  for (const Side side : soccer::kBothSides) {
    for (const int slot : cast.team(side)) {
      put(frame.players[base::index(slot)], world.player(slot));
    }
  }
}

}  // namespace cls::training
