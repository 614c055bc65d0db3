// The whole truth as beliefs.
#include "proxy/coach/global_perception.h"

#include "proxy/estimates/intercept.h"
#include "proxy/estimates/kickers.h"
#include "proxy/estimates/team_lines.h"
#include "proxy/perception/hearing.h"

namespace cls::proxy {
namespace {

using soccer::AngleDeg;
using soccer::Vec2;

// What turns the server's axes into those of our team.
struct Turn {
  double sign = 1.0;

  explicit Turn(soccer::Side side) : sign(side == soccer::Side::kRight ? -1.0 : 1.0) {}
  Vec2 operator()(Vec2 v) const { return v * sign; }
  AngleDeg operator()(double degrees) const { return AngleDeg(degrees + (sign < 0 ? 180.0 : 0.0)); }
};

void see_ball(BallState& ball, const soccer::GlobalView& view, const Turn& turn) {
  ball = {};
  ball.position = ball.seen_position = turn(view.ball_position);
  ball.velocity = ball.seen_velocity = turn(view.ball_velocity);
  ball.pos_count = ball.seen_pos_count = ball.vel_count = ball.seen_vel_count = 0;
  ball.dist_from_self = 0.0;
}

PlayerState player_of(const soccer::GlobalViewPlayer& seen, const Turn& turn) {
  PlayerState player;
  player.unum = seen.unum;
  player.goalie = seen.goalie;
  player.position = player.seen_position = turn(seen.position);
  player.velocity = player.seen_velocity = turn(seen.velocity);
  player.body = turn(seen.body);
  player.face = turn(seen.body + seen.neck);
  if (seen.pointing) player.point_direction = turn(seen.point_direction);
  player.point_count = seen.pointing ? 0 : kNever;
  player.kicking = seen.mark == soccer::ActionMark::kKicked;
  player.tackling = seen.mark == soccer::ActionMark::kTackling;
  for (int* age : {&player.unum_count, &player.pos_count, &player.seen_pos_count, &player.vel_count,
                   &player.seen_vel_count, &player.body_count, &player.face_count}) {
    *age = 0;
  }
  player.dist_from_self = 0.0;
  return player;
}

// By number, as everywhere; the server sends them so unless they came in another order.
void insert(PlayerList& list, const PlayerState& player) {
  if (!list.push_back(player)) return;
  for (std::size_t i = list.size() - 1; i > 0 && list[i].unum < list[i - 1].unum; --i) {
    std::swap(list[i], list[i - 1]);
  }
}

}  // namespace

void on_coach_init(WorldModel& world, soccer::Side side, soccer::TeamName team_name) {
  world.sideline = true;
  world.our_side = side == soccer::Side::kRight ? side : soccer::Side::kLeft;
  world.our_team_name = team_name;
}

void on_global_view(WorldModel& world, const soccer::GlobalView& view) {
  const Turn turn(world.our_side);
  // Nobody tells the mode to a coach who comes in mid-match: he may do least while the ball runs.
  if (view.time > 0 && world.game.mode_start.cycle < 0) {
    world.game.mode = soccer::PlayMode::kPlayOn;
    world.game.mode_start = {view.time, 0};
  }
  open_moment(world.game, view.time);
  world.game.see_time = view.time;
  world.game.last_see = world.game.time;
  see_ball(world.ball, view, turn);
  world.teammates.clear();
  world.opponents.clear();
  for (const soccer::GlobalViewPlayer& seen : view.players) {
    if (seen.unum < 1 || seen.unum > soccer::kPlayersPerTeam) continue;
    const bool ours = seen.team == world.our_team_name;
    PlayerState player = player_of(seen, turn);
    player.side = ours ? world.our_side : world.their_side();
    player.id = seen.unum + (ours ? 0 : soccer::kPlayersPerTeam);
    const auto& types = ours ? world.our_types : world.their_types;
    player.type_id = types[static_cast<std::size_t>(seen.unum - 1)];
    player.dist_from_ball = soccer::distance(player.position, world.ball.position);
    player.angle_from_ball = AngleDeg::of(player.position - world.ball.position);
    if (!ours) world.their_team_name = seen.team;
    if (player.goalie) (ours ? world.our_goalie_unum : world.their_goalie_unum) = player.unum;
    insert(ours ? world.teammates : world.opponents, player);
  }
}

void on_coach_hear(WorldModel& world, const soccer::Hear& hear) {
  if (hear.sender == soccer::Hear::Sender::kReferee) hear_referee(world, hear.time, hear.text);
}

void complete_global(WorldModel& world) {
  ++world.game.set_play_count;
  find_last_kick(world);
  find_kickers(world);
  reckon_intercepts(world);
  draw_lines(world);
}

}  // namespace cls::proxy
