// Exact views as a world model.
#include "proxy/coach/global_perception.h"

#include "base/index.h"
#include "player/estimates/estimates.h"
#include "player/perception/perception.h"
#include "proxy/messages/exact_objects.h"

namespace cls::proxy {
namespace {

player::PlayerState player_of(const soccer::GlobalViewPlayer& seen, const Rotation& rotate) {
  player::PlayerState player;
  set_exact(player, seen, rotate);
  if (seen.pointing) player.point_direction = rotate(seen.point_direction);
  player.point_count = seen.pointing ? 0 : player::kNever;
  player.kicking = seen.mark == soccer::ActionMark::kKicked;
  player.tackling = seen.mark == soccer::ActionMark::kTackling;
  player.dist_from_self = 0.0;
  return player;
}

}  // namespace

void on_coach_init(player::WorldModel& world, soccer::Side side, soccer::TeamName team_name) {
  world.sideline = true;
  world.our_side = side == soccer::Side::kRight ? side : soccer::Side::kLeft;
  world.our_team_name = team_name;
}

void on_global_view(player::WorldModel& world, const soccer::GlobalView& view) {
  // A coach that connects during a match does not receive the play mode; play_on permits least.
  if (view.time > 0 && world.game.mode_start.cycle < 0) {
    world.game.mode = soccer::PlayMode::kPlayOn;
    world.game.mode_start = {view.time, 0};
  }
  begin_step(world.game, view.time);
  world.game.see_time = view.time;
  world.game.last_see = world.game.time;

  const Rotation rotate(world.our_side);
  world.ball = {};
  set_exact(world.ball, view, rotate);
  world.ball.dist_from_self = 0.0;

  world.teammates.clear();
  world.opponents.clear();
  for (const soccer::GlobalViewPlayer& seen : view.players) {
    if (!soccer::is_unum(seen.unum)) continue;
    const bool is_own = seen.team == world.our_team_name;
    player::PlayerState player = player_of(seen, rotate);
    player.side = is_own ? world.our_side : world.their_side();
    player.id = seen.unum + (is_own ? 0 : soccer::kPlayersPerTeam);
    const auto& types = is_own ? world.our_types : world.their_types;
    player.type_id = types[base::index(seen.unum - 1)];
    player.dist_from_ball = soccer::distance(player.position, world.ball.position);
    player.angle_from_ball = soccer::AngleDeg::of(player.position - world.ball.position);

    if (!is_own) world.their_team_name = seen.team;
    if (player.goalie) (is_own ? world.our_goalie_unum : world.their_goalie_unum) = player.unum;
    insert_by_number(is_own ? world.teammates : world.opponents, player);
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
