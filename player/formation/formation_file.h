// Formation files: the cls-formation format and the formats of librcsc.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "player/formation/formation.h"

namespace cls::player {

/// Parses a formation in any supported format (docs/formations.md): `cls-formation 1`, librcsc's
/// JSON and CSV, "Formation Static", and "Formation DelaunayTriangulation" without version or of
/// version 2 or 3. `name` starts the error messages ("name:12: ...").
base::Result<Formation> parse_formation(std::string_view text, const std::string& name);

/// Formats all samples as cls-formation; parse_formation() restores the same bits.
std::string format_formation(const Formation& formation);

}  // namespace cls::player
