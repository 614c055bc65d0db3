// The pitch as one team, or one agent, knows it: plain data that features and skills read.
#pragma once

#include <array>

#include "simulator/world/world.h"
#include "soccer/geometry.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"
#include "soccer/play_mode.h"

namespace cls::training {

using soccer::Side;
using soccer::Vec2;

struct Cast;

/// A player. Meters, meters per cycle, radians.
struct ScenePlayer {
  bool on_pitch = false;  ///< takes part in the episode; otherwise the rest is meaningless
  bool seen = false;      ///< position is known; velocity and body have flags of their own
  bool velocity_known = false;
  bool body_known = false;
  bool goalie = false;
  bool frozen = false;  ///< blocked by a tackle or a foul
  bool hit_ball = false;
  bool hit_player = false;
  bool hit_post = false;
  int unum = 0;
  Vec2 position;
  Vec2 velocity;
  double body = 0.0;
  Vec2 facing;                 ///< unit vector along the body; zero if that is not known
  double ball_distance = 0.0;  ///< meters; meaningless if the ball is not seen
  double stamina = 0.0;
  double effort = 1.0;
  double recovery = 1.0;
  double capacity = -1.0;  ///< of the reserve of stamina; negative: unlimited
  double neck = 0.0;       ///< of the agent alone, relative to the body
  int frozen_cycles = 0;   ///< of the agent alone
  int age = 0;             ///< cycles since the position was seen or heard
  int velocity_age = 0;
  int body_age = 0;
  double kickable_area = 0.0;
  const soccer::PlayerType* type = nullptr;
};

/// Index in Scene::players: the own team is 0..10 by uniform number, the opponents 11..21.
using Seat = int;
constexpr Seat kNoSeat = -1;
constexpr Seat kSeats = soccer::kPlayersOnPitch;

/// Cycles between two readings of the clock of a match: its time, and the cycles that it stood
/// since then.
constexpr int cycles_between(simulator::Clock start, simulator::Clock now) {
  return start.time == now.time ? now.stoppage - start.stoppage
                                : now.time - start.time + now.stoppage;
}

/// Coordinates of the own team, which attacks +x (the right team's are mirrored). y grows
/// downwards for the left team.
struct Scene {
  const soccer::ServerParams* server = nullptr;
  Side side = Side::kLeft;
  soccer::PlayMode mode = soccer::PlayMode::kPlayOn;
  bool play_on = true;  ///< the ball is in play
  bool ball_seen = false;
  bool ball_velocity_known = false;
  Vec2 ball;
  Vec2 ball_velocity;
  int ball_age = 0;  ///< cycles since the position was seen or heard
  int ball_velocity_age = 0;
  int mode_age = 0;                       ///< cycles since the play mode changed
  Side last_touch_side = Side::kNeutral;  ///< who had the ball last; neutral: not known
  Seat last_touch = kNoSeat;              ///< the player, if known
  std::array<ScenePlayer, kSeats> players;

  const ScenePlayer& player(Seat seat) const { return players[static_cast<std::size_t>(seat)]; }
  ScenePlayer& player(Seat seat) { return players[static_cast<std::size_t>(seat)]; }
};

/// Seat of a slot (soccer::slot_of) in the scenes of `side`, and the reverse.
constexpr Seat seat_of(Side side, int slot) {
  if (side != Side::kRight) return slot;
  return slot < soccer::kPlayersPerTeam ? slot + soccer::kPlayersPerTeam
                                        : slot - soccer::kPlayersPerTeam;
}

constexpr bool is_opponent(Seat seat) { return seat >= soccer::kPlayersPerTeam; }

/// The exact world as `side` sees it, but for what only observations read (see below). Players who
/// are not in the cast stay as they are in `out`: not on the pitch. Does not allocate.
void fill_scene(const simulator::World& world, Side side, const Cast& cast, Scene& out);

/// Completes fill_scene() for observers: `facing` and `ball_distance` of all players on the pitch.
void complete_for_observers(Scene& scene);

/// True if the player's kick would reach the ball.
inline bool can_kick(const Scene& scene, Seat seat) {
  const ScenePlayer& player = scene.player(seat);
  return player.seen && scene.ball_seen && !player.frozen &&
         squared_distance(player.position, scene.ball) <=
             player.kickable_area * player.kickable_area;
}

/// Seat of the seen player of a team that is nearest to `point`, without `except`; kNoSeat if none.
Seat nearest_player(const Scene& scene, bool opponents, Vec2 point, Seat except = kNoSeat);

}  // namespace cls::training
