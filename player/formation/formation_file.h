// Formation files: the cls-formation format and the formats of librcsc.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "player/formation/formation.h"

namespace cls::player {

/// Parses a formation in any supported format (docs/formations.md): `cls-formation 1`, librcsc's
/// JSON and CSV, "Formation Static", and "Formation DelaunayTriangulation" without version or of
/// version 2 or 3. `name` starts the error messages ("name:12: ...").
base::Result<Formation> parse_formation(std::string_view text, const std::string& name);

/// Formats all samples as cls-formation; parse_formation() restores the same bits.
std::string format_formation(const Formation& formation);

/// Parses the samples of a librcsc file (formats: formation_file.h); ignores roles and marks. Fails
/// for methods other than Static and DelaunayTriangulation.
base::Result<std::vector<FormationSample>> parse_librcsc_formation(std::string_view text,
                                                                   const std::string& name);

}  // namespace cls::player
