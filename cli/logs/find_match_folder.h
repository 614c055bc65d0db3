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

/// Which of several matches in a folder of match folders.
enum class WantedMatch {
  kFailed,       ///< the latest that failed, otherwise the latest
  kWithGameLog,  ///< the latest with a game log, otherwise the latest
};

/// `folder` is a match folder, a tournament's folder or a folder of match folders. Of several
/// matches of a tournament, it is the latest that failed, otherwise the latest; `index` selects
/// one. The error says what the folder lacks.
base::Result<FoundMatch> find_match_folder(const std::filesystem::path& folder,
                                           std::optional<int> index,
                                           WantedMatch wanted = WantedMatch::kFailed);

}  // namespace cls::cli
