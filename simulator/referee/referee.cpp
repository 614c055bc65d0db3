// Calls the rules in their fixed order.
#include "simulator/referee/referee.h"

#include <array>

#include "simulator/referee/calls.h"
#include "simulator/referee/clearing.h"
#include "simulator/referee/modes.h"
#include "simulator/referee/rule.h"

namespace cls::simulator {
namespace {

constexpr std::array<const Rule*, 10> kRules = {
    &kTimeRule,  &kBallStuckRule, &kOffsideRule,        &kFreeKickRule, &kTouchRule,
    &kCatchRule, &kFoulRule,      &kIllegalDefenseRule, &kKeepawayRule, &kPenaltyRule};

template <typename Member, typename... Arguments>
void notify_rules(World& world, Member Rule::*handler, Arguments&&... arguments) {
  if (!world.rules->has_referee()) return;
  for (const Rule* rule : kRules) {
    if (rule->*handler != nullptr) (rule->*handler)(world, arguments...);
  }
}

Side kick_off_side_after(PlayMode mode, Side before) {
  if (soccer::is_set_play(mode)) return soccer::side(mode);
  if (is_either(mode, PlayMode::kIllegalDefenseLeft)) return opponent(soccer::side(mode));
  return mode == PlayMode::kDropBall ? Side::kNeutral : before;
}

}  // namespace

void run_referee(World& world, Events& events) { notify_rules(world, &Rule::analyze, events); }

void on_kick_taken(World& world, Slot kicker, double acceleration, Events& events) {
  notify_rules(world, &Rule::kick_taken, world.player(kicker), acceleration, events);
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

void on_ball_missed(World& world, Slot player, Events& events) {
  notify_rules(world, &Rule::ball_missed, world.player(player), events);
}

void on_ball_touched(World& world, Slot toucher, Events& events) {
  notify_rules(world, &Rule::ball_touched, world.player(toucher), events);
}

void on_ball_caught(World& world, Slot catcher, Events& events) {
  notify_rules(world, &Rule::ball_caught, world.player(catcher), events);
}

void on_ball_punched(World& world, Slot catcher, Events& events) {
  notify_rules(world, &Rule::ball_punched, world.player(catcher), events);
}

void change_mode(World& world, PlayMode mode, Events& events) {
  world.mode = mode;
  notify_rules(world, &Rule::mode_changed, mode, events);
  world.kick_off_side = kick_off_side_after(mode, world.kick_off_side);
  if (mode == PlayMode::kPlayOn) world.last_play_on = world.clock.time;
  report(events, world, ModeChanged{mode});
  if (!is_goal(mode)) announce(world, {name(mode)}, events);
}

bool wait_after_offense(World& world, int& counter, Side offender, Events& events) {
  constexpr int kWait = 30;
  constexpr int kCleared = 5;
  ++counter;
  if (counter > kWait - kCleared) clear_players_from_ball(world, offender, events);
  return counter > kWait;
}

}  // namespace cls::simulator
