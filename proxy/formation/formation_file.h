// Formations as text: our own format, and the files of teams that use librcsc.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "proxy/formation/formation.h"

namespace cls::proxy {

/// Reads a formation in any of the known forms (docs/formations.md): `cls-formation 1`; librcsc's
/// JSON and CSV files, its "Formation Static" and its "Formation DelaunayTriangulation" without
/// version and of version 2 and 3. `name` begins error messages ("name:12: ...").
base::Result<Formation> parse_formation(std::string_view text, const std::string& name);

/// Writes our own format, all samples in full; parse_formation() reads it back to the same bits.
std::string format_formation(const Formation& formation);

}  // namespace cls::proxy
