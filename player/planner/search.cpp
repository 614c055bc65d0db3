// Best-first search up to a maximum number of nodes.
#include "player/planner/planner.h"

#include <algorithm>
#include <map>
#include <queue>
#include <utility>

#include "player/planner/generators.h"

namespace cls::player {
namespace {

class Search {
 public:
  Search(const PlannerField& field, const PlannerOptions& options, const NodeValue& value)
      : field_(field), options_(options), value_(value) {
    plan_.nodes.reserve(base::index(options.max_nodes) + 1);
  }

  Plan run() {
    add_root();
    while (!open_.empty() && count() < options_.max_nodes) {
      const int node = -open_.top().second;
      open_.pop();
      expand(node);
    }
    return std::move(plan_);
  }

 private:
  int count() const { return static_cast<int>(plan_.nodes.size()); }

  void add_root() {
    const int self = field_.self.unum;
    add({.action = {.sender = self, .target = self, .target_point = field_.ball, .final = true},
         .holder = self,
         .ball = field_.ball,
         .our_defense_line = field_.world.lines.our_defense});
    open_.push({plan_.nodes[0].value, 0});
  }

  void generate(int node) {
    actions_.clear();

    if (node == 0) {
      if (options_.passes) add_passes(field_, actions_);
      if (options_.cross) add_crosses(field_, actions_);
      if (options_.short_dribble) add_short_dribbles(field_, actions_);
      if (options_.long_dribble) add_self_passes(field_, actions_);
      return;
    }

    const CoarseState state{field_, plan_, node};
    if (options_.simple_pass) add_simple_passes(state, actions_);
    if (options_.simple_dribble) add_simple_dribbles(state, actions_);
    if (options_.simple_shoot) add_simple_shot(state, actions_);
  }

  PlanNode child(int parent, const PlanAction& action) const {
    const PlanNode& from = plan_.at(parent);
    return {.action = action,
            .parent = parent,
            .depth = from.depth + 1,
            .holder = action.target,
            .ball = action.target_point,
            .time = from.time + action.duration,
            .our_defense_line = std::min(from.our_defense_line, action.target_point.x)};
  }

  /// Adds and evaluates a node.
  void add(const PlanNode& node) {
    plan_.nodes.push_back(node);
    plan_.nodes.back().value = value_(field_, plan_, count() - 1);
  }

  /// Keeps only the best first actions of each kind and receiver, so that the tree has room for
  /// later actions.
  void prune_first_actions() {
    constexpr int kMaxPerKind = 10;
    std::vector<std::pair<double, std::size_t>> order;

    for (std::size_t i = 0; i < actions_.size(); ++i) {
      add(child(0, actions_[i]));
      order.emplace_back(-plan_.nodes.back().value, i);
      plan_.nodes.pop_back();
    }
    std::ranges::sort(order);

    std::map<std::pair<PlanTag, int>, int> taken;
    std::vector<PlanAction> best;
    const std::size_t max_count = base::index(std::max(10, options_.max_nodes / 3));
    for (const auto& [value, i] : order) {
      const PlanAction& action = actions_[i];
      if (best.size() >= max_count) break;
      if (taken[{action.tag, action.target}]++ < kMaxPerKind) best.push_back(action);
    }

    actions_ = std::move(best);
  }

  void expand(int parent) {
    generate(parent);
    if (parent == 0) prune_first_actions();

    for (const PlanAction& action : actions_) {
      if (count() >= options_.max_nodes) return;
      const int index = count();
      add(child(parent, action));
      const PlanNode& node = plan_.nodes.back();
      if (node.value > plan_.at(plan_.best).value) plan_.best = index;
      // Ties: the earlier node first.
      if (!action.final && node.depth < options_.max_depth) open_.push({node.value, -index});
    }
  }

  const PlannerField& field_;
  const PlannerOptions& options_;
  const NodeValue& value_;
  Plan plan_;
  std::vector<PlanAction> actions_;
  std::priority_queue<std::pair<double, int>> open_;
};

}  // namespace

Plan make_plan(const PlannerField& field, const PlannerOptions& options, const NodeValue& value) {
  return Search(field, options, value).run();
}

}  // namespace cls::player
