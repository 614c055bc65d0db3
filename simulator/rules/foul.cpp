// Fouls: what follows a tackle that the referee saw (9.10).
#include "simulator/referee/areas.h"
#include "simulator/referee/calls.h"
#include "simulator/referee/cards.h"
#include "simulator/referee/modes.h"
#include "simulator/referee/referee.h"
#include "simulator/referee/rule.h"
#include "simulator/rules/foul_detection.h"

namespace cls::simulator {
namespace {

void call_foul(World& world, Player& tackler, Events& events) {
  const Side side = tackler.side;
  ++tackler.fouls;
  world.ball_catcher = kNobody;
  world.referee.foul.counter = 0;
  const Vec2 place = out_of_penalty_area(
      opponent(side), out_of_goal_area(Side::kNeutral, truncated(tackler.position)));
  place_ball(world, for_side(PlayMode::kFoulChargeLeft, side), opponent(side), place, events);
}

void tackle_taken(World& world, Player& tackler, double, bool foul, Events& events) {
  if (soccer::is_penalty_mode(world.mode) || world.params().keepaway) return;
  const FoulCall call = detect_foul(world, tackler, foul);
  if (call == FoulCall::kNone) return;
  call_foul(world, tackler, events);
  if (call == FoulCall::kYellow) show_yellow_card(world, tackler, events);
  if (call == FoulCall::kRed) show_red_card(world, tackler, events);
}

void analyse(World& world, Events& events) {
  if (!is_foul(world.mode)) return;
  const Side offender = soccer::side(world.mode);
  if (!wait_out_offence(world, world.referee.foul.counter, offender, events)) return;
  const PlayMode kick = in_penalty_area(offender, world.ball.position)
                            ? PlayMode::kIndirectFreeKickLeft
                            : PlayMode::kFreeKickLeft;
  change_mode(world, for_side(kick, opponent(offender)), events);
}

}  // namespace

const Rule kFoulRule = {.analyse = analyse, .tackle_taken = tackle_taken};

}  // namespace cls::simulator
