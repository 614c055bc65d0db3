// A world model whose agent and ball were just seen.
#pragma once

#include "player/perception/perception.h"

namespace cls::tests {

/// Number 7 of the left team with full stamina at the center, and the ball there.
inline player::WorldModel known_world() {
  player::WorldModel world;
  on_init(world, {soccer::Side::kLeft, 7, soccer::PlayMode::kPlayOn}, "Us", false);
  world.self.pos_count = world.self.vel_count = world.self.body_count = 0;
  world.self.stamina = 8000.0;
  world.self.capacity = 130600.0;
  world.ball.pos_count = world.ball.seen_pos_count = world.ball.vel_count = 0;
  world.ball.relative_pos_count = 0;
  return world;
}

/// Adds a player whose position is `age` cycles old.
inline player::PlayerState& add(player::WorldModel& world, soccer::Side side, int unum,
                                soccer::Vec2 position, int age = 0) {
  player::PlayerState player;
  player.id = world.next_player_id++;
  player.side = side;
  player.unum = unum;
  player.position = position;
  player.pos_count = player.seen_pos_count = player.vel_count = age;
  player::PlayerList& list = side == world.our_side ? world.teammates : world.opponents;
  list.push_back(player);
  return list.back();
}

}  // namespace cls::tests
