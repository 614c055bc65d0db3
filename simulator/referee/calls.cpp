// Placing the ball for what comes next.
#include "simulator/referee/calls.h"

#include "simulator/referee/areas.h"
#include "simulator/referee/clearing.h"
#include "simulator/referee/referee.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

double away_from_centre(double y, double distance) { return y > 0.0 ? distance : -distance; }

}  // namespace

void announce(World& world, const RefereeSaid& words, Events& events) {
  report(events, world, words);
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
             out_of_penalty_area(opponent(side), truncated(position)), events);
}

void award_goal_kick(World& world, Side side, Events& events) {
  world.ball_catcher = kNobody;
  const double x = -sign(side) * (soccer::kHalfLength - soccer::kGoalAreaLength);
  const double y = away_from_centre(world.ball.position.y, soccer::kGoalAreaWidth / 2.0);
  place_ball(world, for_side(PlayMode::kGoalKickLeft, side), side, {x, y}, events);
}

void award_corner_kick(World& world, Side side, Events& events) {
  world.ball_catcher = kNobody;
  const double margin = world.params().ckick_margin;
  const double x = sign(side) * (soccer::kHalfLength - margin);
  const double y = away_from_centre(world.ball.position.y, soccer::kHalfWidth - margin);
  place_ball(world, for_side(PlayMode::kCornerKickLeft, side), side, {x, y}, events);
}

void award_kick_in(World& world, Side side, Events& events) {
  world.ball_catcher = kNobody;
  place_ball(world, for_side(PlayMode::kKickInLeft, side), side, truncated(world.ball.position),
             events);
}

void drop_ball(World& world, Events& events) {
  drop_ball(world, out_of_penalty_area(Side::kNeutral, truncated(world.ball.position)), events);
}

void drop_ball(World& world, Vec2 place, Events& events) {
  world.ball_catcher = kNobody;
  place_ball(world, PlayMode::kDropBall, Side::kNeutral, place, events);
  keep_players_in_field(world);
  if (!soccer::is_penalty_mode(world.mode)) change_mode(world, PlayMode::kPlayOn, events);
}

}  // namespace cls::simulator
