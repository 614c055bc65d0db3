// The table of planner parameters.
#include "player/world/planner_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text/suggestion.h"

namespace cls::player {

const std::vector<PlannerParameter>& planner_parameter_table() {
  static const std::vector<PlannerParameter> table = [] {
    std::vector<PlannerParameter> rows;
    std::string_view group;
#define CLS_PLANNER_GROUP(title) group = title;
#define CLS_PLANNER_PARAMETER(type, name, value, low, high, unit, effect) \
  rows.push_back({group, #name, &PlannerParameters::name, low, high, unit, effect});
#include "player/world/planner_parameters.inc"
#undef CLS_PLANNER_PARAMETER
#undef CLS_PLANNER_GROUP
    return rows;
  }();

  return table;
}

double value_of(const PlannerParameters& parameters, const PlannerParameter& row) {
  return std::visit([&](auto member) { return static_cast<double>(parameters.*member); },
                    row.member);
}

base::Result<void> set_planner_parameter(PlannerParameters& parameters, std::string_view name,
                                         double value) {
  const auto& table = planner_parameter_table();

  const auto row = std::find_if(table.begin(), table.end(),
                                [name](const PlannerParameter& one) { return one.name == name; });
  if (row == table.end()) {
    std::vector<std::string_view> names;
    for (const PlannerParameter& one : table) names.push_back(one.name);
    return base::Error{
        fmt::format("unknown parameter '{}'{}", name, base::did_you_mean(name, names))};
  }

  const bool whole = !row->integer() || value == std::floor(value);
  if (!whole || !(value >= row->low && value <= row->high)) {
    return base::Error{fmt::format("{}: must be a {}number from {:g} to {:g} ({})", name,
                                   row->integer() ? "whole " : "", row->low, row->high, row->unit)};
  }

  std::visit(
      [&](auto member) {
        auto& place = parameters.*member;
        place = static_cast<std::remove_reference_t<decltype(place)>>(value);
      },
      row->member);

  return {};
}

}  // namespace cls::player
