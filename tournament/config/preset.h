// Configuration files of known competitions, for `cls init --preset`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace cls::tournament {

/// The names of presets: "robocup", "starter", "mixed".
std::vector<std::string_view> preset_names();

/// A commented cls.toml with the format of a competition. `teams` are names of folders beside the
/// file; empty: eight mocks. The error names an unknown preset or a wrong team.
base::Result<std::string> preset_config(std::string_view preset,
                                        const std::vector<std::string>& teams);

}  // namespace cls::tournament
