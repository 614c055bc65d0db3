// What a rule of the game is: functions that are called when something happens.
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

/// A rule leaves out what does not interest it. Its memory is its part of World::referee.
struct Rule {
  /// The world has moved.
  void (*analyse)(World&, Events&) = nullptr;
  /// The ball was kicked, `acceleration` is what it was given.
  void (*kick_taken)(World&, Player& kicker, double acceleration, Events&) = nullptr;
  /// The ball was tackled; without this a tackle is taken for a kick.
  void (*tackle_taken)(World&, Player& tackler, double acceleration, bool foul, Events&) = nullptr;
  /// A kick or tackle did not reach the ball.
  void (*ball_missed)(World&, Player& player, Events&) = nullptr;
  /// Ball and player collided, or a goalie has it.
  void (*ball_touched)(World&, Player& player, Events&) = nullptr;
  void (*ball_caught)(World&, Player& catcher, Events&) = nullptr;
  void (*ball_punched)(World&, Player& catcher, Events&) = nullptr;
  /// The world has this mode now.
  void (*mode_changed)(World&, PlayMode, Events&) = nullptr;
};

extern const Rule kTimeRule;
extern const Rule kBallStuckRule;
extern const Rule kOffsideRule;
extern const Rule kFreeKickRule;
extern const Rule kTouchRule;
extern const Rule kCatchRule;
extern const Rule kFoulRule;
extern const Rule kIllegalDefenseRule;
extern const Rule kKeepawayRule;
extern const Rule kPenaltyRule;

/// One cycle of the pause after an offence of `offender`, whose players are cleared from the ball
/// towards its end. True when it is over (9.5).
bool wait_out_offence(World& world, int& counter, Side offender, Events& events);

}  // namespace cls::simulator
