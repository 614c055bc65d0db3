// What the holder of the ball could do next.
#pragma once

#include <vector>

#include "proxy/planner/field.h"
#include "proxy/planner/plan.h"

namespace cls::proxy {

// First actions of the agent, checked cycle by cycle against all opponents (proxy behaviour 5.2).
// Each appends to `out`.

/// Passes to the feet, into the run, and behind their defence.
void add_passes(const PlannerField& field, std::vector<PlanAction>& out);
/// Hard passes in front of their goal.
void add_crosses(const PlannerField& field, std::vector<PlanAction>& out);
/// One kick, up to two turns, two to four dashes.
void add_short_dribbles(const PlannerField& field, std::vector<PlanAction>& out);
/// A kick far ahead that the agent runs after.
void add_self_passes(const PlannerField& field, std::vector<PlanAction>& out);

// Later actions, checked coarsely: the state's ball at the feet of `holder`, everybody else where
// he is now (the tree's players who had the ball before where they left it).

struct CoarseState {
  const PlannerField& field;
  const Plan& plan;
  int node = 0;

  const PlanNode& now() const { return plan.nodes[static_cast<std::size_t>(node)]; }
  /// Where our player is in this state.
  soccer::Vec2 place_of(const FieldPlayer& player) const;
  /// True when the player had the ball on the way here.
  bool had_ball(int unum) const;
};

void add_simple_passes(const CoarseState& state, std::vector<PlanAction>& out);
void add_simple_dribbles(const CoarseState& state, std::vector<PlanAction>& out);
void add_simple_shot(const CoarseState& state, std::vector<PlanAction>& out);

/// True when the holder of that state sees room between the posts from near enough.
bool can_shoot_from(const PlannerField& field, soccer::Vec2 ball, int holder, int max_age);

}  // namespace cls::proxy
