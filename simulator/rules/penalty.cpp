// Penalty rule: start, phases and results of the kicks of a penalty shoot-out
// (docs/spec/simulation-model.md 9.14).
#include "simulator/rules/penalty.h"

#include <cmath>
#include <optional>

#include "simulator/referee/areas.h"
#include "simulator/referee/rule.h"
#include "simulator/rules/foul.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

constexpr Vec2 kGoalieStart = {42.5, 10.0};

void freeze_ball(World& world, Side kick_off_side) {
  place_ball(world, kick_off_side, world.ball.position);
}

// A trainer may set a shoot-out mode outside a shoot-out or for the wrong side. The mode's side
// then differs from the taker's, which may be neutral. Each decision uses the same side as
// rcssserver.
void prepare_kick(World& world, Events& events) {
  PenaltyState& state = world.referee.penalty;
  state.taker_side = state.taker_side == Side::kLeft ? Side::kRight : Side::kLeft;

  const double x = -sign(state.goal_side) * (soccer::kHalfLength - world.params().pen_dist_x);
  place_ball(world, for_side(PlayMode::kPenaltySetupLeft, state.taker_side), Side::kNeutral,
             {x, 0.0}, events);
}

bool is_due(const World& world) {
  const Rules& rules = *world.rules;
  if (!rules.server.penalty_shoot_outs || world.mode == PlayMode::kBeforeKickOff ||
      world.team(Side::kLeft).score != world.team(Side::kRight).score) {
    return false;
  }

  if (rules.server.half_time >= 0) return world.clock.time >= rules.total_time;
  return rules.server.nr_normal_halfs == 0 && rules.server.nr_extra_halfs == 0;
}

void start_shoot_out(World& world, Events& events) {
  PenaltyState& state = world.referee.penalty;
  const auto draw_side = [&](std::optional<Side> ReplayOverrides::*recorded) {
    const bool left = world.random.shoot_out.uniform(0.0, 1.0) < 0.5;
    const Side drawn = left ? Side::kLeft : Side::kRight;
    return world.overrides ? ((*world.overrides).*recorded).value_or(drawn) : drawn;
  };

  state.started = true;
  state.goal_side = draw_side(&ReplayOverrides::shoot_out_goal);
  world.ball_catcher = kNoPlayer;
  announce(world, {"penalty_onfield", state.goal_side}, events);

  // prepare_kick() changes sides before each kick.
  state.taker_side = opponent(draw_side(&ReplayOverrides::first_penalty_taker));

  for (Player& player : world.players) {
    if (player.enabled && player.goalie && player.side == opponent(state.goal_side)) {
      player.position = {kGoalieStart.x * -sign(state.goal_side), kGoalieStart.y};
    }
  }

  prepare_kick(world, events);
}

void call_penalty_foul(World& world, Side offender, Events& events) {
  const bool left = offender == Side::kLeft;
  announce(world, {"penalty_foul", left ? Side::kLeft : Side::kRight}, events);

  if (offender != Side::kNeutral && offender == world.referee.penalty.taker_side) {
    count_miss(world, offender, events);
  } else {
    count_goal(world, left ? Side::kRight : Side::kLeft, events);
  }
}

void check_ball(World& world, Events& events) {
  PenaltyState& state = world.referee.penalty;
  const double margin = world.params().ball_size;
  const Vec2 ball = world.ball.position;
  const bool taken = is_penalty_taken(world.mode);

  if (crossed_goal_line(world, state.goal_side, state.previous_ball)) {
    if (taken) count_goal(world, soccer::side(world.mode), events);
    freeze_ball(world, state.goal_side);
  } else if (std::fabs(ball.x) > soccer::kHalfLength + margin ||
             std::fabs(ball.y) > soccer::kHalfWidth + margin) {
    freeze_ball(world, state.goal_side);
    if (taken) count_miss(world, soccer::side(world.mode), events);
  }
}

/// Teams that stand as the rules require.
struct Placement {
  bool left;
  bool right;
  bool both() const { return left && right; }
  bool of(Side side) const { return side == Side::kLeft ? left : right; }
};

void replace_misplaced(World& world, Placement& placement) {
  if (!placement.left) place_team(world, Side::kLeft);
  if (!placement.right) place_team(world, Side::kRight);
  placement = {true, true};
}

void punish_misplaced(World& world, Placement placement, Events& events) {
  const Side taker = world.referee.penalty.taker_side;
  if (taker == Side::kNeutral) return;
  call_penalty_foul(world, placement.of(taker) ? opponent(taker) : taker, events);
}

void check_kick(World& world, Placement placement, Events& events) {
  if (is_between_penalties(world.mode)) {
    freeze_ball(world, world.referee.penalty.taker_side);
  } else if (placement.both()) {
    check_ball(world, events);
  } else if (!is_penalty_setup(world.mode)) {
    punish_misplaced(world, placement, events);
  }
}

void handle_timeout(World& world, Placement placement, Events& events) {
  if (is_between_penalties(world.mode)) {
    prepare_kick(world, events);
    return;
  }

  if (is_penalty_setup(world.mode) && world.params().pen_coach_moves_players) {
    replace_misplaced(world, placement);
  }

  if (!placement.both()) {
    punish_misplaced(world, placement, events);
  } else if (is_penalty_setup(world.mode)) {
    change_mode(world, for_side(PlayMode::kPenaltyReadyLeft, soccer::side(world.mode)), events);
  } else {
    count_miss(world, soccer::side(world.mode), events);
  }
}

void analyze_kick(World& world, Events& events) {
  PenaltyState& state = world.referee.penalty;
  if (state.decided) {
    change_mode(world, PlayMode::kTimeOver, events);
    return;
  }

  const PlayMode mode = world.mode;
  Placement placement = {is_team_placed(world, Side::kLeft), is_team_placed(world, Side::kRight)};
  if ((is_penalty_ready(mode) || is_penalty_taken(mode)) &&
      world.params().pen_coach_moves_players) {
    replace_misplaced(world, placement);
  }

  if (state.timer == 0) {
    handle_timeout(world, placement, events);
  } else if (state.timer > 0) {
    --state.timer;
    check_kick(world, placement, events);
  }
}

void analyze(World& world, Events& events) {
  PenaltyState& state = world.referee.penalty;
  if (!state.started && is_due(world)) start_shoot_out(world, events);
  if (soccer::is_penalty_mode(world.mode)) analyze_kick(world, events);

  state.previous_ball = world.ball.position;
}

// Checks whether the kicker may kick; returns the side at fault, if any.
std::optional<Side> offender_of_kick(World& world, const Player& kicker) {
  PenaltyState& state = world.referee.penalty;
  const Side taker_side = state.taker_side;
  const bool by_taker_side = kicker.side == taker_side;

  if (is_penalty_setup(world.mode)) return kicker.side;
  if (is_penalty_taken(world.mode) && by_taker_side && !world.params().pen_allow_mult_kicks) {
    return taker_side;
  }
  if (is_penalty_ready(world.mode) && by_taker_side && has_kicked(world, kicker)) return taker_side;

  // This rule applies to opponents, too: once the taker has kicked, a kick of the defending goalie
  // is a fault of the taker's side (docs/spec/simulation-model.md 15.2).
  const bool taker_has_kicked =
      state.last_taker != kNoPlayer && world.player(state.last_taker).side == taker_side;
  if (taker_has_kicked && state.last_taker != kicker.slot()) return taker_side;
  if (!by_taker_side && !kicker.goalie) return opponent(taker_side);

  state.last_taker = kicker.slot();
  return std::nullopt;
}

void kick_taken(World& world, Player& kicker, double, Events& events) {
  if (!soccer::is_penalty_mode(world.mode) || world.ball_catcher != kNoPlayer) return;

  if (!is_between_penalties(world.mode)) {
    const std::optional<Side> offender = offender_of_kick(world, kicker);
    if (offender) call_penalty_foul(world, *offender, events);
  }

  if (is_penalty_ready(world.mode)) {
    const Side side = soccer::side(world.mode);
    record_kicker(world, side, kicker);
    change_mode(world, for_side(PlayMode::kPenaltyTakenLeft, side), events);
  } else if (!is_penalty_taken(world.mode)) {
    freeze_ball(world, world.referee.penalty.goal_side);
  }
}

void tackle_taken(World& world, Player& tackler, double acceleration, bool foul, Events& events) {
  if (!soccer::is_penalty_mode(world.mode) || is_between_penalties(world.mode)) return;

  if (detect_foul(world, tackler, foul) != FoulCall::kNone) {
    const Side taker = world.referee.penalty.taker_side;
    call_penalty_foul(world, tackler.side == taker ? taker : opponent(taker), events);
  } else {
    kick_taken(world, tackler, acceleration, events);
  }
}

void ball_held(World& world, Player& catcher, Events& events) {
  if (!soccer::is_penalty_mode(world.mode)) return;
  const PenaltyState& state = world.referee.penalty;

  if (is_penalty_taken(world.mode)) {
    if (catcher.side == state.taker_side) {
      call_penalty_foul(world, catcher.side, events);
    } else if (!in_penalty_area(state.goal_side, world.ball.position)) {
      call_penalty_foul(world, opponent(state.taker_side), events);
    } else {
      count_miss(world, state.taker_side, events);
    }
  } else if (is_penalty_ready(world.mode)) {
    call_penalty_foul(world, catcher.side, events);
  }

  freeze_ball(world, Side::kNeutral);
}

void mode_changed(World& world, PlayMode mode, Events&) {
  if (!soccer::is_penalty_mode(mode)) return;

  const soccer::ServerParams& server = world.params();
  PenaltyState& state = world.referee.penalty;
  if (!is_penalty_taken(mode)) state.last_taker = kNoPlayer;

  if (is_penalty_setup(mode)) {
    state.timer = server.pen_setup_wait;
  } else if (is_penalty_ready(mode)) {
    state.timer = server.pen_ready_wait;
  } else if (is_penalty_taken(mode)) {
    state.timer = server.pen_taken_wait;
  } else {
    state.timer = server.pen_before_setup_wait;
  }
}

}  // namespace

const Rule kPenaltyRule = {.analyze = analyze,
                           .kick_taken = kick_taken,
                           .tackle_taken = tackle_taken,
                           .ball_caught = ball_held,
                           .ball_punched = ball_held,
                           .mode_changed = mode_changed};

}  // namespace cls::simulator
