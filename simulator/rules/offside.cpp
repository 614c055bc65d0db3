// Offside rule: a player beyond the offside line at a pass may not play the ball next
// (docs/spec/simulation-model.md 9.8).
#include <algorithm>

#include "base/index.h"
#include "simulator/referee/areas.h"
#include "simulator/referee/clearing.h"
#include "simulator/referee/rule.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

using soccer::Circle;
using soccer::Rect;

Vec2 ball_position_after_offside(const World& world, Vec2 mark) {
  const double margin = world.params().ckick_margin;
  const double goal_kick_x = soccer::kHalfLength - soccer::kGoalAreaLength;
  const double goal_kick_y = soccer::kGoalAreaWidth / 2.0;

  for (const Side side : {Side::kRight, Side::kLeft}) {
    const double end = -sign(side);
    if (mark.x * end > soccer::kHalfLength || in_goal_area(side, mark)) {
      return {goal_kick_x * end, mark.y > 0.0 ? goal_kick_y : -goal_kick_y};
    }
  }

  const Rect inner =
      Rect::centered({}, soccer::kPitchLength - 2.0 * margin, soccer::kPitchWidth - 2.0 * margin);
  return inner.contains(mark) ? mark : nearest_edge(inner, mark);
}

void call_offside(World& world, Events& events) {
  OffsideState& state = world.referee.offside;
  if (soccer::is_penalty_mode(world.mode) || state.kicker_side == Side::kNeutral) return;

  const Side offender = state.kicker_side;
  world.ball_catcher = kNoPlayer;
  state.marks = {};
  state.counter = 0;

  place_ball(world, for_side(PlayMode::kOffsideLeft, offender), opponent(offender),
             ball_position_after_offside(world, state.offense_position), events);
  keep_players_in_field(world);
}

// Offside line for attackers of `side`, in the direction of attack: the second last opponent or the
// ball, at least the center line.
double offside_line(const World& world, Side side) {
  double last = 0.0;
  double second_last = 0.0;
  for (const Player& player : world.players) {
    if (!player.enabled || player.side == side) continue;

    const double x = player.position.x * sign(side);
    if (x > last) {
      second_last = last;
      last = x;
    } else {
      second_last = std::max(second_last, x);
    }
  }

  return std::max(second_last, world.ball.position.x * sign(side));
}

void mark_candidates(World& world, const Player& kicker) {
  const Side side = kicker.side;
  const double line = offside_line(world, side);
  for (const Player& player : world.players) {
    if (!player.enabled || player.side != side || player.unum == kicker.unum) continue;
    if (player.position.x * sign(side) <= line) continue;

    world.referee.offside.marks[base::index(player.slot())] =
        Vec2{line * sign(side), player.position.y};
  }
}

// Two contacts in one step cancel an offside.
bool is_second_contact(const World& world) {
  const OffsideState& state = world.referee.offside;
  return state.has_kick && state.kick_time == world.clock.time &&
         state.kick_stoppage == world.clock.stoppage;
}

void ball_contact(World& world, Player& player, double acceleration, Events& events) {
  if (!world.params().use_offside) return;

  OffsideState& state = world.referee.offside;
  if (is_second_contact(world)) {
    state.kicker_side = Side::kNeutral;
    state.marks = {};
    return;
  }

  if (!state.has_kick || state.kick_time != world.clock.time) state.kick_acceleration = 0.0;
  state.has_kick = true;
  state.kick_time = world.clock.time;
  state.kick_stoppage = world.clock.stoppage;

  // A touch without acceleration never changes the passing side.
  if (state.kick_acceleration < acceleration) {
    state.kicker_side = player.side;
    state.kick_acceleration = acceleration;
  }

  if (const auto& mark = state.marks[base::index(player.slot())]) {
    state.offense_position = *mark;
    call_offside(world, events);
    return;
  }

  state.marks = {};
  const PlayMode mode = world.mode;
  if (is_goal_kick(mode) || is_either(mode, PlayMode::kKickInLeft) ||
      is_either(mode, PlayMode::kCornerKickLeft)) {
    return;
  }

  mark_candidates(world, player);
}

void ball_touched(World& world, Player& player, Events& events) {
  ball_contact(world, player, 0.0, events);
}

void ball_missed(World& world, Player& player, Events& events) {
  OffsideState& state = world.referee.offside;
  const auto& mark = state.marks[base::index(player.slot())];
  if (!mark ||
      distance(player.position, world.ball.position) >= world.params().offside_active_area_size) {
    return;
  }

  state.offense_position = *mark;
  call_offside(world, events);
}

void mode_changed(World& world, PlayMode mode, Events&) {
  if (mode != PlayMode::kPlayOn) world.referee.offside.marks = {};
}

// This radius is not the parameter offside_active_area_size, which has the same default.
constexpr double kClearedRadius = 2.5;

// Moves offenders at or beyond the line behind it and away from the offense
// (docs/spec/simulation-model.md 15.3).
void send_back(World& world, Side offender) {
  const soccer::ServerParams& server = world.params();
  const Vec2 mark = world.referee.offside.offense_position;
  const double own_goal_line = -soccer::kHalfLength * sign(offender);
  const Rect onside = {std::min(own_goal_line, mark.x), std::max(own_goal_line, mark.x),
                       -soccer::kHalfWidth, soccer::kHalfWidth};
  const Circle around{mark, kClearedRadius};

  for (Player& player : world.players) {
    if (!player.enabled || player.side != offender) continue;
    if (around.contains(player.position)) player.position = nearest_edge(around, player.position);
    if (onside.contains(player.position)) continue;
    player.position = nearest_vertical_edge(onside, player.position);
    player.position.x -= server.offside_kick_margin * sign(offender);
  }
}

void analyze(World& world, Events& events) {
  const soccer::ServerParams& server = world.params();
  if (!server.use_offside) return;

  const PlayMode mode = world.mode;
  if (is_either(mode, PlayMode::kOffsideLeft)) {
    const Side offender = soccer::side(mode);
    const bool is_over = wait_after_offense(world, world.referee.offside.counter, offender, events);
    send_back(world, offender);
    if (is_over) change_mode(world, for_side(PlayMode::kFreeKickLeft, opponent(offender)), events);
    return;
  }
  if (mode == PlayMode::kPlayOn) return;

  world.referee.offside.marks = {};
  if (server.forbid_kick_off_offside &&
      (mode == PlayMode::kBeforeKickOff || is_either(mode, PlayMode::kKickOffLeft))) {
    keep_players_in_own_half(world);
  }
}

}  // namespace

const Rule kOffsideRule = {.analyze = analyze,
                           .kick_taken = ball_contact,
                           .ball_missed = ball_missed,
                           .ball_touched = ball_touched,
                           .mode_changed = mode_changed};

}  // namespace cls::simulator
