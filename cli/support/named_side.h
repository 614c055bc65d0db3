// Names of cls.toml as sides of `cls match`.
#pragma once

#include <string>

namespace cls::cli {

/// When `side` is no side form but the name of a team in cls.toml (`config_file`, else the one here
/// or above), puts the team's endpoint in its place, and its name into `team_name` if that is
/// empty. What is wrong is told on stderr; the exit code then is kNoInput, kBadConfig or kUsage,
/// else kDone. A name that no file knows is left as it is.
int resolve_named_side(std::string& side, std::string& team_name, const std::string& config_file);

}  // namespace cls::cli
