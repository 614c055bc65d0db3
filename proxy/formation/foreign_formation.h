// The formation files of teams that use librcsc.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "proxy/formation/formation.h"

namespace cls::proxy {

/// The samples of a file in one of librcsc's forms (formation_file.h); roles and marks are passed
/// over. Other methods than Static and DelaunayTriangulation are named in the error.
base::Result<std::vector<FormationSample>> read_foreign_formation(std::string_view text,
                                                                  const std::string& name);

}  // namespace cls::proxy
