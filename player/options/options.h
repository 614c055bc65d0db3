// A decision of a field player in open play as the choice among options: classes of the planner's
// candidates with the ball, ways of moving without it. Each decision of the planner and of
// basic_move() is exactly one of them.
#pragma once

#include <array>
#include <vector>

#include "player/options/option_ids.h"
#include "player/planner/action_context.h"
#include "player/planner/planner.h"

namespace cls::player {

/// The candidate that stands for its class.
struct OptionTarget {
  int id = 0;
  PlanAction action;
  double room = 0.0;  ///< distance of the nearest opponent to the target, meters
};

/// What the agent may choose now. A copyable value.
struct OptionTable {
  enum class Choice : std::uint8_t {
    kNothing,      ///< set play, goalie, automatic play: `legal` has kAutoOption alone
    kWithBall,     ///< kAutoOption is not legal
    kWithoutBall,  ///< kAutoOption is basic_move()
  };

  Choice choice = Choice::kNothing;
  std::array<bool, kOptionCount> legal{};
  int ball_since = -1;                ///< as in ActionMemory, for this decision
  double shot_gap = 0.0;              ///< free angle of a shot, degrees; 0: none
  std::vector<OptionTarget> targets;  ///< with the ball, one of each legal class, by id
  Moves moves;                        ///< without the ball

  /// Null for options without a target, or which are not legal.
  const OptionTarget* target(int id) const;
  /// Cycles since the agent got the ball.
  int held(const WorldModel& world) const {
    return ball_since < 0 ? 0 : world.game.time.cycle - ball_since;
  }
};

/// Where a legal option leads.
OptionAim aim_of(const WorldModel& world, const OptionTable& table, int id);

/// Plays between begin_decision() and finish_decision() what nobody chooses: automatic play, set
/// plays, the goalie. False without effect if there is something to choose.
bool play_without_choice(ActionContext& context);

/// Of the due decision. `world` is completed, `memory` that of the decision before. Replaces `out`
/// and keeps its memory.
void find_options(const WorldModel& world, const ActionMemory& memory, OptionTable& out);

/// The same after begin_decision().
void find_options(const ActionContext& begun, OptionTable& out);

/// The option that the planner chooses with the ball, or basic_move() without it; -1 where there is
/// nothing to choose.
int planner_option(const WorldModel& world, const OptionTable& table,
                   const PlannerOptions& options);

/// Plays the decision between begin_decision() and finish_decision(). Where `id` is not legal, the
/// agent holds the ball, or plays kAutoOption without it. `table` is that of this decision.
void play_option(ActionContext& context, const OptionTable& table, int id);

}  // namespace cls::player
