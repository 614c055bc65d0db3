// Converts estimates to the units of scenes.
#include "training/scene/estimated_scene.h"

#include <algorithm>

#include "soccer/math.h"

namespace cls::training {
namespace {

double radians(soccer::AngleDeg angle) { return soccer::math::to_radians(angle.degrees()); }

void fill_self(const player::WorldModel& world, ScenePlayer& out) {
  const player::SelfState& self = world.self;
  out.seen = self.position_valid();
  out.velocity_known = true;
  out.body_known = true;
  out.goalie = world.goalie;
  out.frozen = self.frozen();
  out.hit_ball = self.collided_with_ball;
  out.hit_player = self.collided_with_player;
  out.hit_post = self.collided_with_post;

  out.position = self.position;
  out.velocity = self.velocity;
  out.body = radians(self.body);
  out.facing = soccer::polar_radians(1.0, out.body);
  out.stamina = self.stamina;
  out.effort = self.effort;
  out.recovery = self.recovery;
  out.capacity = self.capacity;
  out.neck = radians(self.neck);
  out.frozen_cycles = std::max(self.tackle_expires_in, self.foul_charged);
  out.age = self.pos_count;
  out.velocity_age = self.vel_count;
  out.body_age = self.body_count;
  out.type = &world.self_type();
}

void fill_player(const player::WorldModel& world, const player::PlayerState& player,
                 ScenePlayer& out) {
  out.seen = player.position_valid();
  out.velocity_known = player.velocity_valid();
  out.body_known = player.body_count < player::kPlayerFaceAgeLimit;
  out.goalie = player.goalie;
  out.frozen = player.tackling;

  out.position = player.position;
  out.velocity = player.velocity;
  out.body = radians(player.body);
  out.age = player.pos_count;
  out.velocity_age = player.vel_count;
  out.body_age = player.body_count;
  if (out.body_known) out.facing = soccer::polar_radians(1.0, out.body);

  // Stamina of others is unknown: scenes show that of a rested player.
  out.type = &world.type_of(player);
  out.stamina = world.server().stamina_max;
  out.effort = out.type->effort_max;
}

// The seat of a numbered player, or the first of the cast that is free.
Seat choose_seat(const Cast& cast, Side side, bool opponent, int unum, const Scene& scene) {
  const Side team = opponent ? soccer::opponent(side) : side;
  for (const int slot : cast.team(team)) {
    const Seat seat = seat_of(side, slot);
    if (unum != 0 ? soccer::unum_of_slot(slot) == unum : !scene.player(seat).seen) return seat;
  }
  return kNoSeat;
}

void add_players(const player::WorldModel& world, const player::PlayerList& players, bool opponents,
                 const Cast& cast, Scene& out) {
  // Numbered players come first in the list, so that the others find the free seats.
  for (const player::PlayerState& player : players) {
    if (!player.position_valid()) continue;
    const Seat seat = choose_seat(cast, world.our_side, opponents, player.unum, out);
    if (seat != kNoSeat) fill_player(world, player, out.player(seat));
  }
}

void fill_history(const player::WorldModel& world, Scene& out) {
  const player::GameTime now = world.game.time;
  const player::GameTime start = world.game.mode_start;  // cycle -1 before any announcement
  const simulator::Clock began{std::max(start.cycle, 0), start.stopped};
  out.mode_age = std::max(0, cycles_between(began, {now.cycle, now.stopped}));

  const player::LastKick& last = world.last_kick;
  out.last_touch_side = last.side;
  out.last_touch = kNoSeat;
  if (last.side != Side::kNeutral && last.unum > 0) {
    out.last_touch = seat_of(world.our_side, soccer::slot_of(last.side, last.unum));
  }
}

}  // namespace

void fill_scene(const player::WorldModel& world, const Cast& cast, Scene& out) {
  out.server = &world.server();
  out.side = world.our_side;
  out.mode = world.game.mode;
  out.play_on = world.game.mode == soccer::PlayMode::kPlayOn;

  out.ball_seen = world.ball.position_valid();
  out.ball_velocity_known = world.ball.velocity_valid();
  out.ball = world.ball.position;
  out.ball_velocity = world.ball.velocity;
  out.ball_age = world.ball.pos_count;
  out.ball_velocity_age = world.ball.vel_count;

  fill_history(world, out);

  for (ScenePlayer& player : out.players) player = {};
  for (const Side side : {Side::kLeft, Side::kRight}) {
    for (const int slot : cast.team(side)) {
      ScenePlayer& player = out.player(seat_of(world.our_side, slot));
      player.on_pitch = true;
      player.unum = soccer::unum_of_slot(slot);
    }
  }

  // First, so that no teammate takes the agent's own seat.
  fill_self(world, out.player(world.unum - 1));
  add_players(world, world.teammates, false, cast, out);
  add_players(world, world.opponents, true, cast, out);

  for (ScenePlayer& player : out.players) {
    if (player.type == nullptr) continue;
    player.kickable_area = player.type->kickable_area(world.server().ball_size);
    player.ball_distance = distance(player.position, out.ball);
  }
}

}  // namespace cls::training
