// Free kick rule: takers of set plays, distance of opponents, double touches
// (docs/spec/simulation-model.md 9.7).
#include "simulator/referee/areas.h"
#include "simulator/referee/clearing.h"
#include "simulator/referee/rule.h"

namespace cls::simulator {
namespace {

void call_double_touch(World& world, Player& player, Events& events) {
  player.state |= state::kFreeKickFault;
  const Side side = player.side;

  world.ball_catcher = kNoPlayer;
  world.referee.free_kick.counter = 0;
  place_ball(world, for_side(PlayMode::kFreeKickFaultLeft, side), opponent(side),
             move_out_of_penalty_area(side, clamp_to_pitch(world.ball.position)), events);
}

void repeat_goal_kick(World& world, Side side, Events& events) {
  award_goal_kick(world, side, events);
  world.referee.free_kick.goal_kicks = -1;
  world.referee.free_kick.taken = false;
}

void record_taker(World& world, const Player& player) {
  FreeKickState& state = world.referee.free_kick;
  state.taken = true;
  state.taker = player.slot();
  state.taker_dashes = player.counters.dash;
}

void kick_at_goal_kick(World& world, Player& kicker, Events& events) {
  const soccer::ServerParams& server = world.params();
  const FreeKickState& state = world.referee.free_kick;
  const Side side = soccer::side(world.mode);

  if (kicker.side != side) {
    repeat_goal_kick(world, side, events);
    return;
  }

  if (state.taken) {
    const bool is_other_player = state.taker != kicker.slot();
    const bool is_second_touch = !is_other_player && state.taker_dashes != kicker.counters.dash;
    if (is_second_touch && server.free_kick_faults) {
      call_double_touch(world, kicker, events);
    } else if ((is_other_player || is_second_touch) && server.proper_goal_kicks) {
      award_goal_kick(world, side, events);
    }
  }

  record_taker(world, kicker);
}

// Kicks without a dash in between count as one kick; after a dash the next is a second touch.
void check_double_touch(World& world, Player& player, bool reset_without_rule, Events& events) {
  FreeKickState& state = world.referee.free_kick;
  if (!state.taken) return;

  if (state.taker != player.slot()) {
    state.taken = false;
  } else if (!world.params().free_kick_faults) {
    if (reset_without_rule) state.taken = false;
  } else if (player.counters.dash > state.taker_dashes) {
    call_double_touch(world, player, events);
  }
}

void kick_taken(World& world, Player& kicker, double, Events& events) {
  const PlayMode mode = world.mode;
  if (soccer::is_penalty_mode(mode) || is_either(mode, PlayMode::kOffsideLeft)) return;

  if (is_goal_kick(mode)) {
    kick_at_goal_kick(world, kicker, events);
  } else if (mode == PlayMode::kPlayOn) {
    check_double_touch(world, kicker, true, events);
  } else {
    record_taker(world, kicker);
    change_mode(world, PlayMode::kPlayOn, events);
  }
}

void ball_touched(World& world, Player& player, Events& events) {
  if (is_goal_kick(world.mode) && player.side != soccer::side(world.mode)) {
    repeat_goal_kick(world, soccer::side(world.mode), events);
  }

  check_double_touch(world, player, false, events);
}

void mode_changed(World& world, PlayMode mode, Events& events) {
  FreeKickState& state = world.referee.free_kick;
  if (mode != PlayMode::kPlayOn) state.taken = false;

  if (soccer::is_set_play(mode)) {
    clear_players_from_ball(world, opponent(soccer::side(mode)), events);
  } else if (mode == PlayMode::kDropBall) {
    clear_players_from_ball(world, Side::kNeutral, events);
  }

  state.goal_kicks = is_goal_kick(mode) ? state.goal_kicks + 1 : 0;
  state.timer = soccer::is_set_play(mode) ? world.params().drop_ball_time : -1;
}

void count_down_to_drop(World& world, Events& events) {
  int& timer = world.referee.free_kick.timer;
  if (timer > 0 && --timer == 0) drop_ball(world, events);
}

void analyze_goal_kick(World& world, Events& events) {
  const soccer::ServerParams& server = world.params();
  const FreeKickState& state = world.referee.free_kick;
  const Side side = soccer::side(world.mode);

  clear_penalty_area(world, side);
  keep_players_in_field(world);

  if (!in_penalty_area(Side::kNeutral, world.ball.position)) {
    change_mode(world, PlayMode::kPlayOn, events);
  } else if (!state.taken || !server.proper_goal_kicks) {
    count_down_to_drop(world, events);
  } else if (world.ball.velocity.length() < server.stopped_ball_vel) {
    if (state.goal_kicks >= server.max_goal_kicks) {
      award_free_kick(world, opponent(side), world.ball.position, events);
    } else {
      award_goal_kick(world, side, events);
    }
  }
}

bool resumes_when_ball_moves(PlayMode mode) {
  return soccer::is_set_play(mode) || mode == PlayMode::kDropBall || is_trainer_only_mode(mode);
}

bool requires_distance(PlayMode mode) {
  return mode == PlayMode::kBeforeKickOff || is_goal(mode) || resumes_when_ball_moves(mode);
}

void analyze(World& world, Events& events) {
  const PlayMode mode = world.mode;
  if (soccer::is_penalty_mode(mode)) return;

  if (is_either(mode, PlayMode::kFreeKickFaultLeft)) {
    const Side offender = soccer::side(mode);
    if (wait_after_offense(world, world.referee.free_kick.counter, offender, events)) {
      change_mode(world, for_side(PlayMode::kFreeKickLeft, opponent(offender)), events);
    }
    return;
  }

  if (is_either(mode, PlayMode::kBackPassLeft) || is_either(mode, PlayMode::kCatchFaultLeft)) {
    return;
  }

  if (is_goal_kick(mode)) {
    analyze_goal_kick(world, events);
    return;
  }

  if (resumes_when_ball_moves(mode) && !world.ball.velocity.is_zero()) {
    change_mode(world, PlayMode::kPlayOn, events);
  }

  keep_players_in_field(world);
  if (!requires_distance(mode)) return;

  clear_players_from_ball(world, opponent(world.kick_off_side), events);
  count_down_to_drop(world, events);
}

}  // namespace

const Rule kFreeKickRule = {.analyze = analyze,
                            .kick_taken = kick_taken,
                            .ball_touched = ball_touched,
                            .mode_changed = mode_changed};

}  // namespace cls::simulator
