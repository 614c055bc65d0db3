// Files with parameters of the offensive planner (docs/mock.md): TOML, `NAME = VALUE` lines.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"

namespace cls::player {
struct PlannerParameters;
}

namespace cls::match {

using SharedPlannerParameters = std::shared_ptr<const player::PlannerParameters>;

/// Parameters that the text does not name have their defaults. `name` is the file name in errors,
/// which name the line, the parameter and what it must be.
base::Result<SharedPlannerParameters> parse_planner_file(std::string_view text,
                                                         const std::string& name);

/// Parses the parameters of a file; the error says why it cannot be read.
base::Result<SharedPlannerParameters> read_planner_file(const std::filesystem::path& file);

/// A file with all parameters, their defaults, units, ranges and effects.
std::string commented_planner_file();

}  // namespace cls::match
