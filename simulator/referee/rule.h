// Interface of a referee rule: a table of event handlers, and what rules may call.
#pragma once

#include "simulator/referee/modes.h"
#include "simulator/referee/referee.h"

namespace cls::simulator {

/// Handlers that a rule does not need stay null. Its state is a member of World::referee.
struct Rule {
  /// Called in every step, after motion.
  void (*analyze)(World&, Events&) = nullptr;
  /// `acceleration`: length of the acceleration given to the ball.
  void (*kick_taken)(World&, Player& kicker, double acceleration, Events&) = nullptr;
  /// Without this handler a tackle is passed to kick_taken.
  void (*tackle_taken)(World&, Player& tackler, double acceleration, bool foul, Events&) = nullptr;
  /// A kick or tackle did not reach the ball.
  void (*ball_missed)(World&, Player& player, Events&) = nullptr;
  /// The ball collided with the player, or a goalie caught or punched it.
  void (*ball_touched)(World&, Player& player, Events&) = nullptr;
  void (*ball_caught)(World&, Player& catcher, Events&) = nullptr;
  void (*ball_punched)(World&, Player& catcher, Events&) = nullptr;
  /// Called after the mode was set.
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

/// Counts one cycle of the pause after an offense; near its end clears the offender's players from
/// the ball. Returns true when the pause is over (docs/spec/simulation-model.md 9.5).
bool wait_after_offense(World& world, int& counter, Side offender, Events& events);

}  // namespace cls::simulator
