// The list of action sets, and the layout of their values.
#include "training/actions/action_set.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>

#include "base/index.h"
#include "player/options/options.h"

namespace cls::training {
namespace {

// Of one set: the largest has 18 (skills).
constexpr std::size_t kMaxConditions = 32;

}  // namespace

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

Legality::Legality(const ActionSet& set) : options_(set.options) {
  for (std::size_t id = 0; id < set.actions.size(); ++id) {
    const Condition legal = set.actions[id].legal;
    const auto known = std::ranges::find(conditions_, legal);
    const std::size_t condition = base::index(known - conditions_.begin());
    if (known == conditions_.end()) conditions_.push_back(legal);

    const bool continues = !runs_.empty() && runs_.back().condition == condition;
    if (!continues) runs_.push_back({condition, id, 0});
    ++runs_.back().count;
  }
  assert(conditions_.size() <= kMaxConditions);
}

void Legality::fill(const PointOfView& view, std::uint8_t* mask) const {
  if (options_) {
    std::ranges::copy(view.options->legal, mask);
    return;
  }

  std::array<std::uint8_t, kMaxConditions> holds;
  for (std::size_t i = 0; i < conditions_.size(); ++i) {
    holds[i] = conditions_[i] == nullptr || conditions_[i](view) ? 1 : 0;
  }
  for (const Run& run : runs_) std::fill_n(mask + run.first, run.count, holds[run.condition]);
}

const std::vector<const ActionSet*>& action_sets() {
  static const std::vector<const ActionSet*> sets = {
      &low_actions(), &low_all_actions(), &low_flat_actions(), &low_discrete_actions(),
      &hfo_actions(), &skill_actions(),   &option_actions()};
  return sets;
}

const ActionSet* find_action_set(std::string_view name) {
  const auto found = std::ranges::find(action_sets(), name, &ActionSet::name);
  return found == action_sets().end() ? nullptr : *found;
}

}  // namespace cls::training
