// Exact views as a world model.
#include "proxy/coach/global_perception.h"

#include "player/estimates/ball_control.h"
#include "player/estimates/intercept.h"
#include "player/estimates/team_lines.h"
#include "player/perception/hearing.h"

namespace cls::proxy {
namespace {

using soccer::AngleDeg;
using soccer::Vec2;

// Rotates the server's coordinates so that the own team attacks +x.
struct Rotation {
  double sign = 1.0;

  explicit Rotation(soccer::Side side) : sign(side == soccer::Side::kRight ? -1.0 : 1.0) {}
  Vec2 operator()(Vec2 v) const { return v * sign; }
  AngleDeg operator()(double degrees) const { return AngleDeg(degrees + (sign < 0 ? 180.0 : 0.0)); }
};

void see_ball(player::BallState& ball, const soccer::GlobalView& view, const Rotation& rotate) {
  ball = {};
  ball.position = ball.seen_position = rotate(view.ball_position);
  ball.velocity = ball.seen_velocity = rotate(view.ball_velocity);
  ball.pos_count = ball.seen_pos_count = ball.vel_count = ball.seen_vel_count = 0;
  ball.dist_from_self = 0.0;
}

player::PlayerState player_of(const soccer::GlobalViewPlayer& seen, const Rotation& rotate) {
  player::PlayerState player;
  player.unum = seen.unum;
  player.goalie = seen.goalie;
  player.position = player.seen_position = rotate(seen.position);
  player.velocity = player.seen_velocity = rotate(seen.velocity);
  player.body = rotate(seen.body);
  player.face = rotate(seen.body + seen.neck);
  if (seen.pointing) player.point_direction = rotate(seen.point_direction);
  player.point_count = seen.pointing ? 0 : player::kNever;
  player.kicking = seen.mark == soccer::ActionMark::kKicked;
  player.tackling = seen.mark == soccer::ActionMark::kTackling;
  for (int* age : {&player.unum_count, &player.pos_count, &player.seen_pos_count, &player.vel_count,
                   &player.seen_vel_count, &player.body_count, &player.face_count}) {
    *age = 0;
  }
  player.dist_from_self = 0.0;
  return player;
}

// Sorted by uniform number; the server usually sends this order.
void insert(player::PlayerList& list, const player::PlayerState& player) {
  if (!list.push_back(player)) return;
  for (std::size_t i = list.size() - 1; i > 0 && list[i].unum < list[i - 1].unum; --i) {
    std::swap(list[i], list[i - 1]);
  }
}

}  // namespace

void on_coach_init(player::WorldModel& world, soccer::Side side, soccer::TeamName team_name) {
  world.sideline = true;
  world.our_side = side == soccer::Side::kRight ? side : soccer::Side::kLeft;
  world.our_team_name = team_name;
}

void on_global_view(player::WorldModel& world, const soccer::GlobalView& view) {
  const Rotation rotate(world.our_side);
  // A coach that connects during a match does not receive the play mode; play_on permits least.
  if (view.time > 0 && world.game.mode_start.cycle < 0) {
    world.game.mode = soccer::PlayMode::kPlayOn;
    world.game.mode_start = {view.time, 0};
  }
  begin_step(world.game, view.time);
  world.game.see_time = view.time;
  world.game.last_see = world.game.time;
  see_ball(world.ball, view, rotate);
  world.teammates.clear();
  world.opponents.clear();
  for (const soccer::GlobalViewPlayer& seen : view.players) {
    if (seen.unum < 1 || seen.unum > soccer::kPlayersPerTeam) continue;
    const bool is_own = seen.team == world.our_team_name;
    player::PlayerState player = player_of(seen, rotate);
    player.side = is_own ? world.our_side : world.their_side();
    player.id = seen.unum + (is_own ? 0 : soccer::kPlayersPerTeam);
    const auto& types = is_own ? world.our_types : world.their_types;
    player.type_id = types[static_cast<std::size_t>(seen.unum - 1)];
    player.dist_from_ball = soccer::distance(player.position, world.ball.position);
    player.angle_from_ball = AngleDeg::of(player.position - world.ball.position);
    if (!is_own) world.their_team_name = seen.team;
    if (player.goalie) (is_own ? world.our_goalie_unum : world.their_goalie_unum) = player.unum;
    insert(is_own ? world.teammates : world.opponents, player);
  }
}

void on_coach_hear(player::WorldModel& world, const soccer::Hear& hear) {
  if (hear.sender == soccer::Hear::Sender::kReferee) hear_referee(world, hear.time, hear.text);
}

void complete_global(player::WorldModel& world) {
  ++world.game.set_play_count;
  update_last_kicker(world);
  update_kickable_players(world);
  update_intercept_table(world);
  update_team_lines(world);
}

}  // namespace cls::proxy
