// Copies the exact world into a scene.
#include "training/scene/scene.h"

#include <limits>

#include "soccer/math.h"

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
  out.facing = soccer::polar_radians(1.0, out.body);

  out.stamina = player.stamina.value;
  out.effort = player.stamina.effort;
  out.type = &world.type_of(player);
  out.kickable_area = out.type->kickable_area(world.params().ball_size);
}

}  // namespace

void fill_scene(const simulator::World& world, Side side, Scene& out) {
  const int sign = soccer::sign(side);
  out.server = &world.params();
  out.side = side;
  out.play_on = world.mode == soccer::PlayMode::kPlayOn;

  out.ball_seen = out.ball_velocity_known = true;
  out.ball = world.ball.position * sign;
  out.ball_velocity = world.ball.velocity * sign;

  for (int slot = 0; slot < kSeats; ++slot) {
    fill_player(world, world.player(slot), sign, out.player(seat_of(side, slot)));
  }
}

bool can_kick(const Scene& scene, Seat seat) {
  const ScenePlayer& player = scene.player(seat);
  return player.seen && scene.ball_seen && !player.frozen &&
         squared_distance(player.position, scene.ball) <=
             player.kickable_area * player.kickable_area;
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
