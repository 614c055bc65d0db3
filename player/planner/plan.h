// Planner data: actions, states, and the search tree.
#pragma once

#include <cstdint>
#include <vector>

#include "base/index.h"
#include "player/world/vocabulary.h"

namespace cls::player {

enum class PlanCategory : std::uint8_t { kHold, kDribble, kPass, kShoot, kClear, kMove, kNoAction };

/// Generator of the action; wire names in planner_messages.cpp.
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

/// An action with the ball. Meters, meters per cycle, cycles, degrees.
struct PlanAction {
  PlanCategory category = PlanCategory::kHold;
  PlanTag tag = PlanTag::kHold;
  int sender = 0;  ///< uniform numbers of our team
  int target = 0;
  Vec2 target_point{};
  double first_speed = 0.0;
  Vec2 first_velocity{};  ///< of the ball, for dribbles
  double turn = 0.0;      ///< total turn before the dashes, relative to the body
  int duration = 0;
  int kicks = 0;
  int turns = 0;
  int dashes = 0;
  bool final = false;  ///< not expanded further
};

/// A node: an action and the resulting state, with the ball at its holder.
struct PlanNode {
  PlanAction action;
  int parent = -1;  ///< index of a node; -1 for the root
  int depth = 0;    ///< actions up to here
  int holder = 0;
  Vec2 ball{};
  int time = 0;  ///< cycles from now
  double our_defense_line = 0.0;
  double value = 0.0;
};

/// Node 0 is the root: the current state, hold.
struct Plan {
  std::vector<PlanNode> nodes;
  int best = 0;  ///< node with the highest value

  bool empty() const { return nodes.empty(); }
  const PlanNode& at(int node) const { return nodes[base::index(node)]; }
  /// Node of the first action on the path to `node`; 0 for the root.
  int first_of(int node) const {
    while (node > 0 && at(node).parent > 0) node = at(node).parent;
    return node;
  }
};

/// Enabled generators and limits.
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

}  // namespace cls::player
