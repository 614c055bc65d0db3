// Ball and players without noise, as the server sends them to coaches and in full states.
#pragma once

#include <utility>

#include "player/world/world_model.h"

namespace cls::proxy {

/// Rotates the server's coordinates so that the own team attacks +x.
struct Rotation {
  bool turned = false;

  explicit Rotation(soccer::Side own) : turned(own == soccer::Side::kRight) {}
  soccer::Vec2 operator()(soccer::Vec2 v) const { return turned ? -v : v; }
  soccer::AngleDeg operator()(double degrees) const {
    return soccer::AngleDeg(degrees + (turned ? 180.0 : 0.0));
  }
};

/// Replaces position and velocity; `view` is a soccer::GlobalView or a soccer::FullState.
template <typename View>
void set_exact(player::BallState& ball, const View& view, const Rotation& rotate) {
  ball.position = ball.seen_position = rotate(view.ball_position);
  ball.velocity = ball.seen_velocity = rotate(view.ball_velocity);
  ball.pos_count = ball.seen_pos_count = ball.vel_count = ball.seen_vel_count = 0;
}

/// Replaces number, position, velocity and directions; `seen` is a player of such a view.
template <typename Seen>
void set_exact(player::PlayerState& player, const Seen& seen, const Rotation& rotate) {
  player.unum = seen.unum;
  player.goalie = seen.goalie;
  player.position = player.seen_position = rotate(seen.position);
  player.velocity = player.seen_velocity = rotate(seen.velocity);
  player.body = rotate(seen.body);
  player.face = rotate(seen.body + seen.neck);
  player.unum_count = player.body_count = player.face_count = 0;
  player.pos_count = player.seen_pos_count = player.vel_count = player.seen_vel_count = 0;
}

/// Sorted by number, as the list of a world model is; the server usually sends this order.
inline void insert_by_number(player::PlayerList& list, const player::PlayerState& player) {
  if (!list.push_back(player)) return;
  for (std::size_t i = list.size() - 1; i > 0 && list[i].unum < list[i - 1].unum; --i) {
    std::swap(list[i], list[i - 1]);
  }
}

}  // namespace cls::proxy
