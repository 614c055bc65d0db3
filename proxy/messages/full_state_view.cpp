// Rotates the server's coordinates and replaces the estimates.
#include "proxy/messages/full_state_view.h"

#include "base/index.h"
#include "proxy/messages/exact_objects.h"

namespace cls::proxy {
namespace {

using player::PlayerState;
using soccer::FullStatePlayer;

void set_self(player::SelfState& self, const FullStatePlayer& seen, const Rotation& rotate) {
  self.position = self.seen_position = rotate(seen.position);
  self.velocity = self.seen_velocity = rotate(seen.velocity);
  self.body = rotate(seen.body);
  self.neck = soccer::AngleDeg(seen.neck);
  self.position_deviation = self.body_deviation = 0.0;
  self.pos_count = self.seen_pos_count = self.vel_count = self.seen_vel_count = 0;
  self.body_count = 0;
}

void set_ball(player::BallState& ball, const soccer::FullState& state, soccer::Vec2 self,
              const Rotation& rotate) {
  set_exact(ball, state, rotate);
  ball.relative_position = ball.seen_relative_position = ball.position - self;
  ball.position_deviation = ball.velocity_deviation = 0.0;
  ball.relative_pos_count = ball.lost_count = ball.ghost_count = 0;
}

// `known` is the estimate of the same player, or a new one.
PlayerState exact_player(PlayerState known, const FullStatePlayer& seen, const Rotation& rotate) {
  set_exact(known, seen, rotate);
  known.side = seen.side;
  known.type_id = seen.type;
  known.covariance = {};
  known.ghost_count = 0;
  if (seen.mark == soccer::ActionMark::kKicked) known.kick_count = 0;
  if (seen.mark == soccer::ActionMark::kTackling) known.tackle_count = 0;
  return known;
}

}  // namespace

player::WorldModel full_state_view(const player::WorldModel& world,
                                   const soccer::FullState& state) {
  const Rotation rotate(world.our_side);
  player::WorldModel exact = world;
  exact.teammates.clear();
  exact.opponents.clear();
  exact.unknowns.clear();

  for (const FullStatePlayer& seen : state.players) {
    if (seen.unum < 1 || seen.unum > soccer::kPlayersPerTeam) continue;
    const bool own = seen.side == world.our_side;
    if (own && seen.unum == world.unum) {
      set_self(exact.self, seen, rotate);
      continue;
    }

    const PlayerState* known = own ? world.teammate(seen.unum) : world.opponent(seen.unum);
    PlayerState player = known != nullptr ? *known : PlayerState();
    if (known == nullptr) player.id = exact.next_player_id++;
    insert_by_number(own ? exact.teammates : exact.opponents, exact_player(player, seen, rotate));
    if (!own) exact.their_types[base::index(seen.unum - 1)] = seen.type;
  }

  set_ball(exact.ball, state, exact.self.position, rotate);
  return exact;
}

}  // namespace cls::proxy
