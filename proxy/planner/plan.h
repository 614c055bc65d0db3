// The planner's vocabulary: actions, the states they lead to, and the tree of both.
#pragma once

#include <cstdint>
#include <vector>

#include "soccer/geometry.h"

namespace cls::proxy {

enum class PlanCategory : std::uint8_t { kHold, kDribble, kPass, kShoot, kClear, kMove, kNoAction };

/// How the action was found; names on the wire in planner_messages.h.
enum class PlanTag : std::uint8_t {
  kHold,
  kStrictDirect,
  kStrictLead,
  kStrictThrough,
  kCross,
  kShortDribble,
  kSelfPass,
  kSimplePass,
  kSimpleDribble,
  kSimpleShoot,
};

/// What somebody does with the ball. Metres, metres per cycle, cycles, degrees.
struct PlanAction {
  PlanCategory category = PlanCategory::kHold;
  PlanTag tag = PlanTag::kHold;
  int sender = 0;  ///< numbers of our team
  int target = 0;
  soccer::Vec2 target_point;
  double first_speed = 0.0;
  soccer::Vec2 first_velocity;  ///< of the ball, for dribbles
  double turn = 0.0;            ///< total turn before the dashes, relative to the body
  int duration = 0;
  int kicks = 0;
  int turns = 0;
  int dashes = 0;
  bool final = false;  ///< nothing is planned beyond it
};

/// A node: the action that leads to it, and the state then. The ball lies at its holder's feet.
struct PlanNode {
  PlanAction action;
  int parent = -1;  ///< index of a node; -1 for the root
  int depth = 0;    ///< actions up to here
  int holder = 0;
  soccer::Vec2 ball;
  int time = 0;  ///< cycles from now
  double our_defence_line = 0.0;
  double value = 0.0;
};

/// Node 0 is the root: the present state, holding the ball.
struct Plan {
  std::vector<PlanNode> nodes;
  int best = 0;  ///< node of the highest value

  bool empty() const { return nodes.empty(); }
  /// The node of the first action on the way to `node`; 0 for the root.
  int first_of(int node) const {
    while (node > 0 && nodes[static_cast<std::size_t>(node)].parent > 0) {
      node = nodes[static_cast<std::size_t>(node)].parent;
    }
    return node;
  }
};

/// What the planner may do.
struct PlannerOptions {
  bool passes = true;
  bool cross = true;
  bool short_dribble = true;
  bool long_dribble = true;
  bool simple_pass = false;
  bool simple_dribble = false;
  bool simple_shoot = true;
  int max_depth = 4;
  int max_nodes = 500;
};

}  // namespace cls::proxy
