// Rotates the server's coordinates and replaces the estimates.
#include "proxy/messages/exact_view.h"

#include <utility>

namespace cls::proxy {
namespace {

using player::PlayerState;
using soccer::AngleDeg;
using soccer::FullStatePlayer;
using soccer::Vec2;

// The own team attacks +x.
struct Rotation {
  bool turned = false;
  Vec2 operator()(Vec2 v) const { return turned ? -v : v; }
  AngleDeg operator()(double degrees) const { return AngleDeg(degrees + (turned ? 180.0 : 0.0)); }
};

void set_self(player::SelfState& self, const FullStatePlayer& seen, const Rotation& rotate) {
  self.position = self.seen_position = rotate(seen.position);
  self.velocity = self.seen_velocity = rotate(seen.velocity);
  self.body = rotate(seen.body);
  self.neck = AngleDeg(seen.neck);
  self.position_deviation = self.body_deviation = 0.0;
  for (int* age : {&self.pos_count, &self.seen_pos_count, &self.vel_count, &self.seen_vel_count,
                   &self.body_count}) {
    *age = 0;
  }
}

void set_ball(player::BallState& ball, const soccer::FullState& state, Vec2 self,
              const Rotation& rotate) {
  ball.position = ball.seen_position = rotate(state.ball_position);
  ball.velocity = ball.seen_velocity = rotate(state.ball_velocity);
  ball.relative_position = ball.seen_relative_position = ball.position - self;
  ball.position_deviation = ball.velocity_deviation = 0.0;
  for (int* age : {&ball.pos_count, &ball.relative_pos_count, &ball.seen_pos_count, &ball.vel_count,
                   &ball.seen_vel_count, &ball.lost_count, &ball.ghost_count}) {
    *age = 0;
  }
}

// `known` is the estimate of the same player, or a new one.
PlayerState exact_player(PlayerState known, const FullStatePlayer& seen, const Rotation& rotate) {
  known.side = seen.side;
  known.unum = seen.unum;
  known.goalie = seen.goalie;
  known.type_id = seen.type;
  known.position = known.seen_position = rotate(seen.position);
  known.velocity = known.seen_velocity = rotate(seen.velocity);
  known.body = rotate(seen.body);
  known.face = rotate(seen.body + seen.neck);
  known.covariance = {};
  for (int* age :
       {&known.unum_count, &known.pos_count, &known.seen_pos_count, &known.vel_count,
        &known.seen_vel_count, &known.body_count, &known.face_count, &known.ghost_count}) {
    *age = 0;
  }
  if (seen.mark == soccer::ActionMark::kKicked) known.kick_count = 0;
  if (seen.mark == soccer::ActionMark::kTackling) known.tackle_count = 0;
  return known;
}

// Sorted by number, as the list of a world model is; the server usually sends this order.
void insert(player::PlayerList& list, const PlayerState& player) {
  if (!list.push_back(player)) return;
  for (std::size_t i = list.size() - 1; i > 0 && list[i].unum < list[i - 1].unum; --i) {
    std::swap(list[i], list[i - 1]);
  }
}

}  // namespace

player::WorldModel exact_view(const player::WorldModel& world, const soccer::FullState& state) {
  const Rotation rotate{world.our_side == soccer::Side::kRight};
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
    insert(own ? exact.teammates : exact.opponents, exact_player(player, seen, rotate));
    if (!own) exact.their_types[static_cast<std::size_t>(seen.unum - 1)] = seen.type;
  }
  set_ball(exact.ball, state, exact.self.position, rotate);
  return exact;
}

}  // namespace cls::proxy
