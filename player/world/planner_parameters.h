// Parameters of the offensive planner and of home positions, which users may tune.
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "base/result.h"

namespace cls::player {

/// One team's parameters; units and effects are in planner_parameters.inc.
struct PlannerParameters {
#define CLS_PLANNER_GROUP(title)
#define CLS_PLANNER_PARAMETER(type, name, value, low, high, unit, effect) type name = value;
#include "player/world/planner_parameters.inc"
#undef CLS_PLANNER_PARAMETER
#undef CLS_PLANNER_GROUP
};

/// A row of the table of parameters.
struct PlannerParameter {
  using Member = std::variant<double PlannerParameters::*, int PlannerParameters::*>;

  std::string_view group;  ///< title
  std::string_view name;
  Member member;
  double low;  ///< both bounds are allowed
  double high;
  std::string_view unit;
  std::string_view effect;

  bool integer() const { return std::holds_alternative<int PlannerParameters::*>(member); }
};

/// All rows, by group.
const std::vector<PlannerParameter>& planner_parameter_table();

double value_of(const PlannerParameters& parameters, const PlannerParameter& row);

/// Sets the parameter `name`. Errors: an unknown name, with a suggestion; a value out of range, or
/// with a fraction where the parameter counts.
base::Result<void> set_planner_parameter(PlannerParameters& parameters, std::string_view name,
                                         double value);

}  // namespace cls::player
