// Places the ball for the next set play and shows cards.
#include "simulator/referee/calls.h"

#include "simulator/referee/areas.h"
#include "simulator/referee/clearing.h"
#include "simulator/referee/referee.h"
#include "simulator/world/roster.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

double with_sign_of(double y, double distance) { return y > 0.0 ? distance : -distance; }

}  // namespace

void announce(World& world, const RefereeMessage& message, Events& events) {
  report(events, world, message);
}

void place_ball(World& world, Side side, Vec2 position) {
  world.ball = {position, {}, {}};
  world.kick_off_side = side;
}

void place_ball(World& world, PlayMode mode, Side side, Vec2 position, Events& events) {
  place_ball(world, side, position);
  const bool resumes = mode == PlayMode::kPlayOn || mode == PlayMode::kDropBall;
  if (resumes && soccer::is_penalty_mode(world.mode)) return;
  change_mode(world, mode, events);
}

void award_free_kick(World& world, Side side, Vec2 position, Events& events) {
  place_ball(world, for_side(PlayMode::kFreeKickLeft, side), side,
             move_out_of_penalty_area(opponent(side), clamp_to_pitch(position)), events);
}

void award_goal_kick(World& world, Side side, Events& events) {
  world.ball_catcher = kNoPlayer;
  const double x = -sign(side) * (soccer::kHalfLength - soccer::kGoalAreaLength);
  const double y = with_sign_of(world.ball.position.y, soccer::kGoalAreaWidth / 2.0);
  place_ball(world, for_side(PlayMode::kGoalKickLeft, side), side, {x, y}, events);
}

void award_corner_kick(World& world, Side side, Events& events) {
  world.ball_catcher = kNoPlayer;
  const double margin = world.params().ckick_margin;
  const double x = sign(side) * (soccer::kHalfLength - margin);
  const double y = with_sign_of(world.ball.position.y, soccer::kHalfWidth - margin);
  place_ball(world, for_side(PlayMode::kCornerKickLeft, side), side, {x, y}, events);
}

void award_kick_in(World& world, Side side, Events& events) {
  world.ball_catcher = kNoPlayer;
  place_ball(world, for_side(PlayMode::kKickInLeft, side), side,
             clamp_to_pitch(world.ball.position), events);
}

void drop_ball(World& world, Events& events) {
  drop_ball(world, move_out_of_penalty_area(Side::kNeutral, clamp_to_pitch(world.ball.position)),
            events);
}

void drop_ball(World& world, Vec2 position, Events& events) {
  world.ball_catcher = kNoPlayer;
  place_ball(world, PlayMode::kDropBall, Side::kNeutral, position, events);
  keep_players_in_field(world);
  if (!soccer::is_penalty_mode(world.mode)) change_mode(world, PlayMode::kPlayOn, events);
}

void show_yellow_card(World& world, Player& player, Events& events) {
  announce(world, {"yellow_card", player.side, player.unum}, events);
  ++player.cards;
  player.state |= state::kYellowCard;
  if (player.cards > 1) show_red_card(world, player, events);
}

void show_red_card(World& world, Player& player, Events& events) {
  announce(world, {"red_card", player.side, player.unum}, events);
  send_off(world, player.slot(), events);
}

}  // namespace cls::simulator
