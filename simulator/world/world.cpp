// Creates the world before the match.
#include "simulator/world/world.h"

#include <utility>

namespace cls::simulator {
namespace {

namespace math = soccer::math;

template <std::size_t... kSlots>
PlayerStreams per_player(std::uint64_t seed, std::string_view purpose,
                         std::index_sequence<kSlots...>) {
  return {RandomStream(seed, purpose, kSlots)...};
}

PlayerStreams per_player(std::uint64_t seed, std::string_view purpose) {
  return per_player(seed, purpose, std::make_index_sequence<soccer::kPlayersOnPitch>());
}

Player make_player(Slot slot, const Rules& rules) {
  Player player;
  player.side = soccer::side_of_slot(slot);
  player.unum = soccer::unum_of_slot(slot);
  player.position = bench_position(player);
  player.arm.age = rules.server.point_to_duration;
  const soccer::PlayerType& type = rules.types.front();
  player.stamina = {rules.server.stamina_max, type.effort_max, 1.0, rules.server.stamina_capacity};
  player.ears.teammate_capacity = rules.server.hear_max;
  player.ears.opponent_capacity = rules.server.hear_max;
  return player;
}

// Ranges of random wind as in rcssserver (docs/spec/simulation-model.md 3.2).
Wind make_wind(const soccer::ServerParams& server, std::uint64_t seed) {
  if (server.wind_none) return {};
  if (!server.wind_random) {
    return {soccer::polar_degrees(server.wind_force, server.wind_dir), server.wind_rand};
  }
  RandomStream stream(seed, "wind");
  const double force = stream.uniform(0.0, 100.0);
  const double direction = stream.uniform(-math::kPi, math::kPi);
  return {soccer::polar_radians(force, direction), stream.uniform(0.0, 0.5)};
}

}  // namespace

// Changing the name of a stream changes every match.
RandomStreams::RandomStreams(std::uint64_t seed)
    : ball_motion(seed, "ball motion"),
      player_motion(per_player(seed, "player motion")),
      turn(per_player(seed, "turn")),
      kick_noise(per_player(seed, "kick noise")),
      tackle(per_player(seed, "tackle")),
      tackle_noise(per_player(seed, "tackle noise")),
      catch_ball(per_player(seed, "catch")),
      foul(per_player(seed, "foul")),
      collision(seed, "collision"),
      placement(seed, "placement"),
      shoot_out(seed, "shoot-out") {}

Vec2 bench_position(const Player& player) {
  return {-3.0 * player.unum * sign(player.side), -37.0};
}

World make_world(std::shared_ptr<const Rules> rules, std::uint64_t seed) {
  World world;
  world.seed = seed;
  world.random = RandomStreams(seed);
  for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    world.player(slot) = make_player(slot, *rules);
  }
  const soccer::ServerParams& server = rules->server;
  world.team(Side::kLeft).score = server.start_goal_l;
  world.team(Side::kRight).score = server.start_goal_r;
  world.wind = make_wind(server, seed);
  world.auto_mode = {server.kick_off_wait, server.connect_wait, server.game_over_wait, false};
  world.rules = std::move(rules);
  return world;
}

RandomStream clock_stream(const World& world, std::string_view purpose, Slot slot) {
  const auto time = static_cast<std::uint64_t>(world.clock.time);
  const auto stoppage = static_cast<std::uint64_t>(world.clock.stoppage);
  return RandomStream(world.seed, purpose, static_cast<std::uint64_t>(slot),
                      (time << 32) | stoppage);
}

bool is_kickable(const World& world, const Player& player) {
  const double area = world.type_of(player).kickable_area(world.params().ball_size);
  return squared_distance(world.ball.position, player.position) <= area * area;
}

}  // namespace cls::simulator
