// The match folder that a user means: itself, one of a tournament, one of runs/.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/result.h"

namespace cls::cli {

struct FoundMatch {
  std::filesystem::path folder;
  std::string why;  ///< "match 3", "the latest that failed"; empty: the folder itself
};

/// `folder` is a match folder, a tournament's folder or a folder of match folders. Of several
/// matches, it is the latest that failed, otherwise the latest; `index` selects a match of a
/// tournament. The error says what the folder lacks.
base::Result<FoundMatch> find_match_folder(const std::filesystem::path& folder,
                                           std::optional<int> index);

}  // namespace cls::cli
