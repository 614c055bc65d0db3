// Copies the exact world into a scene.
#include "training/scene/scene.h"

#include <algorithm>
#include <limits>

#include "soccer/directions.h"
#include "soccer/math.h"
#include "training/scene/cast.h"

namespace cls::training {
namespace {

namespace math = soccer::math;

void fill_player(const simulator::World& world, const simulator::Player& player, int sign,
                 ScenePlayer& out) {
  out.on_pitch = player.enabled;
  if (!player.enabled) {
    out.seen = false;
    return;
  }

  out.seen = out.velocity_known = out.body_known = true;
  out.goalie = player.goalie;
  out.frozen = player.tackle_cycles > 0 || player.foul_cycles > 0;
  out.hit_ball = player.contacts.ball;
  out.hit_player = player.contacts.player;
  out.hit_post = player.contacts.post;
  out.unum = player.unum;

  out.position = player.position * sign;
  out.velocity = player.velocity * sign;
  out.body = sign > 0 ? player.body : math::normalize_radians(player.body + math::kPi);

  out.stamina = player.stamina.value;
  out.effort = player.stamina.effort;
  out.recovery = player.stamina.recovery;
  out.capacity = player.stamina.capacity;
  out.neck = player.neck;
  out.frozen_cycles = std::max(player.tackle_cycles, player.foul_cycles);
  out.type = &world.type_of(player);
  out.kickable_area = out.type->kickable_area(world.params().ball_size);
}

}  // namespace

void fill_scene(const simulator::World& world, Side side, const Cast& cast, Scene& out) {
  const int sign = soccer::sign(side);
  out.server = &world.params();
  out.side = side;
  out.mode = world.mode;
  out.play_on = world.mode == soccer::PlayMode::kPlayOn;

  out.ball_seen = out.ball_velocity_known = true;
  out.ball = world.ball.position * sign;
  out.ball_velocity = world.ball.velocity * sign;

  for (const Side team : {Side::kLeft, Side::kRight}) {
    for (const int slot : cast.team(team)) {
      fill_player(world, world.player(slot), sign, out.player(seat_of(side, slot)));
    }
  }
}

void complete_for_observers(Scene& scene) {
  std::array<ScenePlayer*, kSeats> players{};
  std::array<double, kSeats> bodies{};
  std::size_t count = 0;
  for (ScenePlayer& player : scene.players) {
    if (!player.on_pitch) continue;
    players[count] = &player;
    bodies[count++] = player.body;
    player.ball_distance = distance(player.position, scene.ball);
  }

  std::array<Vec2, kSeats> facing;
  soccer::unit_vectors(bodies.data(), count, facing.data());
  for (std::size_t i = 0; i < count; ++i) players[i]->facing = facing[i];
}

Seat nearest_player(const Scene& scene, bool opponents, Vec2 point, Seat except) {
  Seat nearest = kNoSeat;
  double best = std::numeric_limits<double>::infinity();
  const Seat first = opponents ? soccer::kPlayersPerTeam : 0;

  for (Seat seat = first; seat < first + soccer::kPlayersPerTeam; ++seat) {
    const ScenePlayer& player = scene.player(seat);
    if (!player.seen || seat == except) continue;
    const double distance = squared_distance(player.position, point);
    if (distance < best) {
      best = distance;
      nearest = seat;
    }
  }
  return nearest;
}

}  // namespace cls::training
