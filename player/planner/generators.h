// Action generators of the planner.
#pragma once

#include <vector>

#include "player/planner/field.h"
#include "player/planner/plan.h"

namespace cls::player {

// First actions of the agent, simulated cycle by cycle against all opponents
// (docs/spec/proxy-behavior.md 5.2). Each appends to `out`.

/// Direct, lead and through passes.
void add_passes(const PlannerField& field, std::vector<PlanAction>& out);
/// Crosses: hard passes in front of their goal.
void add_crosses(const PlannerField& field, std::vector<PlanAction>& out);
/// One kick, up to two turns, two to four dashes.
void add_short_dribbles(const PlannerField& field, std::vector<PlanAction>& out);
/// Self passes (long dribbles): a kick far ahead that the agent runs after.
void add_self_passes(const PlannerField& field, std::vector<PlanAction>& out);

// Later actions with coarse checks: the ball is at the holder; all other players stay at their
// current position (earlier holders where they released the ball).

struct CoarseState {
  const PlannerField& field;
  const Plan& plan;
  int node = 0;

  const PlanNode& now() const { return plan.at(node); }
  /// Position of our player in this state.
  Vec2 position_of(const FieldPlayer& player) const;
  /// True if the player had the ball on the path to this state.
  bool had_ball(int unum) const;
};

void add_simple_passes(const CoarseState& state, std::vector<PlanAction>& out);
void add_simple_dribbles(const CoarseState& state, std::vector<PlanAction>& out);
void add_simple_shot(const CoarseState& state, std::vector<PlanAction>& out);

/// True if the holder is in shooting range and sees a gap between the posts.
bool can_shoot_from(const PlannerField& field, Vec2 ball, int holder, int max_age);

}  // namespace cls::player
