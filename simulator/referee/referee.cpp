// Asking the rules in their order.
#include "simulator/referee/referee.h"

#include <array>

#include "simulator/referee/auto_mode.h"
#include "simulator/referee/calls.h"
#include "simulator/referee/clearing.h"
#include "simulator/referee/modes.h"
#include "simulator/referee/rule.h"
#include "simulator/referee/substitution.h"
#include "simulator/world/stamina.h"

namespace cls::simulator {
namespace {

constexpr std::array<const Rule*, 10> kRules = {
    &kTimeRule,  &kBallStuckRule, &kOffsideRule,        &kFreeKickRule, &kTouchRule,
    &kCatchRule, &kFoulRule,      &kIllegalDefenseRule, &kKeepawayRule, &kPenaltyRule};

template <typename Member, typename... Arguments>
void ask(World& world, Member Rule::*question, Arguments&&... arguments) {
  if (!world.rules->has_referee()) return;
  for (const Rule* rule : kRules) {
    if (rule->*question != nullptr) (rule->*question)(world, arguments...);
  }
}

// Neutral: the mode does not say.
Side kick_off_side_of(PlayMode mode, Side before) {
  if (soccer::is_set_play(mode)) return soccer::side(mode);
  if (is_either(mode, PlayMode::kIllegalDefenseLeft)) return opponent(soccer::side(mode));
  return mode == PlayMode::kDropBall ? Side::kNeutral : before;
}

}  // namespace

void run_referee(World& world, Events& events) { ask(world, &Rule::analyse, events); }

void on_kick_taken(World& world, Slot kicker, double acceleration, Events& events) {
  ask(world, &Rule::kick_taken, world.player(kicker), acceleration, events);
}

void on_tackle_taken(World& world, Slot tackler, double acceleration, bool foul, Events& events) {
  if (!world.rules->has_referee()) return;
  Player& player = world.player(tackler);
  for (const Rule* rule : kRules) {
    if (rule->tackle_taken != nullptr) {
      rule->tackle_taken(world, player, acceleration, foul, events);
    } else if (rule->kick_taken != nullptr) {
      rule->kick_taken(world, player, acceleration, events);
    }
  }
}

void on_ball_missed(World& world, Slot who, Events& events) {
  ask(world, &Rule::ball_missed, world.player(who), events);
}

void on_ball_touched(World& world, Slot toucher, Events& events) {
  ask(world, &Rule::ball_touched, world.player(toucher), events);
}

void on_ball_caught(World& world, Slot catcher, Events& events) {
  ask(world, &Rule::ball_caught, world.player(catcher), events);
}

void on_ball_punched(World& world, Slot catcher, Events& events) {
  ask(world, &Rule::ball_punched, world.player(catcher), events);
}

void change_mode(World& world, PlayMode mode, Events& events) {
  world.mode = mode;
  ask(world, &Rule::mode_changed, mode, events);
  world.kick_off_side = kick_off_side_of(mode, world.kick_off_side);
  if (mode == PlayMode::kPlayOn) world.last_play_on = world.clock.time;
  report(events, world, ModeChanged{mode});
  if (!is_goal(mode)) announce(world, {name(mode)}, events);
}

bool wait_out_offence(World& world, int& counter, Side offender, Events& events) {
  constexpr int kWait = 30;
  constexpr int kCleared = 5;
  ++counter;
  if (counter > kWait - kCleared) clear_players_from_ball(world, offender, events);
  return counter > kWait;
}

}  // namespace cls::simulator
