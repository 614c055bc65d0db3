// The list of action sets, and the layout of their values.
#include "training/actions/action_set.h"

#include <string>

namespace cls::training {

Columns ActionSet::values() const {
  if (actions.empty()) return box;
  Columns all;
  for (const Action& action : actions) {
    for (Column column : action.parameters) {
      column.name = std::string(action.name) + "_" + column.name;
      all.push_back(std::move(column));
    }
  }
  return all;
}

std::vector<int> ActionSet::offsets() const {
  std::vector<int> firsts;
  int next = 0;
  for (const Action& action : actions) {
    firsts.push_back(next);
    next += static_cast<int>(action.parameters.size());
  }
  return firsts;
}

const std::vector<const ActionSet*>& action_sets() {
  static const std::vector<const ActionSet*> sets = {&low_actions(),      &low_all_actions(),
                                                     &low_flat_actions(), &low_discrete_actions(),
                                                     &hfo_actions(),      &skill_actions()};
  return sets;
}

const ActionSet* find_action_set(std::string_view name) {
  for (const ActionSet* set : action_sets()) {
    if (set->name == name) return set;
  }
  return nullptr;
}

}  // namespace cls::training
