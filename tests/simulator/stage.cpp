// Sets up worlds and runs commands and steps.
#include "tests/simulator/stage.h"

#include <gtest/gtest.h>

#include "soccer/commands/player_command.h"

namespace cls::tests {

using namespace cls::simulator;

soccer::ServerParams noise_free_params(const Change& change) {
  soccer::ServerParams server;
  server.player_rand = 0.0;
  server.ball_rand = 0.0;
  server.kick_rand = 0.0;
  if (change) change(server);
  return server;
}

World make_match(const soccer::ServerParams& server, const soccer::PlayerParams& player,
                 std::uint64_t seed) {
  return make_world(make_rules(server, player, seed).value(), seed);
}

Stage::Stage(const soccer::ServerParams& server) : world(make_match(server)) {
  world.clock.time = 10;
  set_mode(PlayMode::kPlayOn);
  events.clear();
}

Player& Stage::add(Side side, Vec2 position, bool goalie) {
  Player& player = world.player(join(world, side, goalie, 19).value());
  player.body = player.pending_body = 0.0;
  return place(player, position);
}

Player& Stage::place(Player& player, Vec2 position, Vec2 velocity) {
  player.position = position;
  player.velocity = velocity;
  return player;
}

void Stage::place_ball(Vec2 position, Vec2 velocity) { move_ball(world, position, velocity); }

void Stage::set_mode(PlayMode mode) { change_mode(world, mode, events); }

bool Stage::command(const Player& player, const std::string& datagram) {
  std::vector<soccer::PlayerCommand> commands;
  const bool read = !soccer::parse_player_commands(datagram, commands);
  for (const soccer::PlayerCommand& each : commands) {
    reply = apply(world, player.slot(), each, events);
  }
  return read;
}

void Stage::step(int count) {
  for (int i = 0; i < count; ++i) {
    simulator::step(world, events);
    finish_step(world, events);
  }
}

int Stage::step_until_mode_changes(int max_steps) {
  const PlayMode before = world.mode;
  int steps = 0;
  while (world.mode == before && steps < max_steps) {
    step();
    ++steps;
  }
  return steps;
}

Calls Stage::take_calls() {
  Calls result;
  for (const Event& event : events) {
    if (const auto* message = std::get_if<RefereeMessage>(&event.what)) {
      result.push_back(std::to_string(event.clock.time) + ' ' + message->text());
    }
  }
  events.clear();
  return result;
}

void expect_near(Vec2 actual, Vec2 expected, double tolerance) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
}

double body_degrees(const Player& player) { return soccer::math::to_degrees(player.body); }

}  // namespace cls::tests
