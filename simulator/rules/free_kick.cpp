// Set plays: who may take them, how near the others may come, and the double touch (9.7).
#include "simulator/referee/areas.h"
#include "simulator/referee/calls.h"
#include "simulator/referee/clearing.h"
#include "simulator/referee/modes.h"
#include "simulator/referee/referee.h"
#include "simulator/referee/rule.h"

namespace cls::simulator {
namespace {

void call_double_touch(World& world, Player& player, Events& events) {
  player.state |= state::kFreeKickFault;
  const Side side = player.side;
  world.ball_catcher = kNobody;
  world.referee.free_kick.counter = 0;
  place_ball(world, for_side(PlayMode::kFreeKickFaultLeft, side), opponent(side),
             out_of_penalty_area(side, truncated(world.ball.position)), events);
}

void repeat_goal_kick(World& world, Side side, Events& events) {
  award_goal_kick(world, side, events);
  world.referee.free_kick.goal_kicks = -1;
  world.referee.free_kick.taken = false;
}

void remember_taker(World& world, const Player& player) {
  FreeKickRule& memory = world.referee.free_kick;
  memory.taken = true;
  memory.taker = player.slot();
  memory.taker_dashes = player.counters.dash;
}

void kick_at_goal_kick(World& world, Player& kicker, Events& events) {
  const soccer::ServerParams& server = world.params();
  const FreeKickRule& memory = world.referee.free_kick;
  const Side side = soccer::side(world.mode);
  if (kicker.side != side) {
    repeat_goal_kick(world, side, events);
    return;
  }
  if (memory.taken) {
    const bool is_other = memory.taker != kicker.slot();
    const bool is_second_touch = !is_other && memory.taker_dashes != kicker.counters.dash;
    if (is_second_touch && server.free_kick_faults) {
      call_double_touch(world, kicker, events);
    } else if ((is_other || is_second_touch) && server.proper_goal_kicks) {
      award_goal_kick(world, side, events);
    }
  }
  remember_taker(world, kicker);
}

// Kicks without a dash in between are one kick; a dash makes the next one a second touch.
void check_double_touch(World& world, Player& player, bool rule_off_forgets, Events& events) {
  FreeKickRule& memory = world.referee.free_kick;
  if (!memory.taken) return;
  if (memory.taker != player.slot()) {
    memory.taken = false;
  } else if (!world.params().free_kick_faults) {
    if (rule_off_forgets) memory.taken = false;
  } else if (player.counters.dash > memory.taker_dashes) {
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
    remember_taker(world, kicker);
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
  FreeKickRule& memory = world.referee.free_kick;
  if (mode != PlayMode::kPlayOn) memory.taken = false;
  if (soccer::is_set_play(mode)) {
    clear_players_from_ball(world, opponent(soccer::side(mode)), events);
  } else if (mode == PlayMode::kDropBall) {
    clear_players_from_ball(world, Side::kNeutral, events);
  }
  memory.goal_kicks = is_goal_kick(mode) ? memory.goal_kicks + 1 : 0;
  memory.timer = soccer::is_set_play(mode) ? world.params().drop_ball_time : -1;
}

void count_down_to_drop(World& world, Events& events) {
  int& timer = world.referee.free_kick.timer;
  if (timer > 0 && --timer == 0) drop_ball(world, events);
}

void analyse_goal_kick(World& world, Events& events) {
  const soccer::ServerParams& server = world.params();
  const FreeKickRule& memory = world.referee.free_kick;
  const Side side = soccer::side(world.mode);
  clear_penalty_area(world, side);
  keep_players_in_field(world);
  if (!in_penalty_area(Side::kNeutral, world.ball.position)) {
    change_mode(world, PlayMode::kPlayOn, events);
  } else if (!memory.taken || !server.proper_goal_kicks) {
    count_down_to_drop(world, events);
  } else if (world.ball.velocity.length() < server.stopped_ball_vel) {
    if (memory.goal_kicks >= server.max_goal_kicks) {
      award_free_kick(world, opponent(side), world.ball.position, events);
    } else {
      award_goal_kick(world, side, events);
    }
  }
}

bool starts_by_a_moving_ball(PlayMode mode) {
  return soccer::is_set_play(mode) || mode == PlayMode::kDropBall || is_unusual(mode);
}

bool keeps_distance(PlayMode mode) {
  return mode == PlayMode::kBeforeKickOff || is_goal(mode) || starts_by_a_moving_ball(mode);
}

void analyse(World& world, Events& events) {
  const PlayMode mode = world.mode;
  if (soccer::is_penalty_mode(mode)) return;
  if (is_either(mode, PlayMode::kFreeKickFaultLeft)) {
    const Side offender = soccer::side(mode);
    if (wait_out_offence(world, world.referee.free_kick.counter, offender, events)) {
      change_mode(world, for_side(PlayMode::kFreeKickLeft, opponent(offender)), events);
    }
    return;
  }
  if (is_either(mode, PlayMode::kBackPassLeft) || is_either(mode, PlayMode::kCatchFaultLeft)) {
    return;
  }
  if (is_goal_kick(mode)) {
    analyse_goal_kick(world, events);
    return;
  }
  if (starts_by_a_moving_ball(mode) && !world.ball.velocity.is_zero()) {
    change_mode(world, PlayMode::kPlayOn, events);
  }
  keep_players_in_field(world);
  if (!keeps_distance(mode)) return;
  clear_players_from_ball(world, opponent(world.kick_off_side), events);
  count_down_to_drop(world, events);
}

}  // namespace

const Rule kFreeKickRule = {.analyse = analyse,
                            .kick_taken = kick_taken,
                            .ball_touched = ball_touched,
                            .mode_changed = mode_changed};

}  // namespace cls::simulator
