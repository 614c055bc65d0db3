// Formation files of teams based on librcsc.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "player/formation/formation.h"

namespace cls::player {

/// Parses the samples of a librcsc file (formats: formation_file.h); ignores roles and marks. Fails
/// for methods other than Static and DelaunayTriangulation.
base::Result<std::vector<FormationSample>> parse_librcsc_formation(std::string_view text,
                                                                   const std::string& name);

}  // namespace cls::player
