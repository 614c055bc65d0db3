// Deletes old match folders of a folder such as runs/.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/result.h"

namespace cls::cli {

/// Match folders that are deleted, or would be.
struct PrunedMatches {
  std::vector<std::filesystem::path> folders;  ///< oldest first
  std::uintmax_t bytes = 0;                    ///< of their files
  std::size_t left = 0;                        ///< match folders that remain
};

/// The match folders directly in `folder` but for the newest `keep`. Leaves out links, tournaments,
/// and matches that are played now. The error says why there is nothing to delete from.
base::Result<PrunedMatches> find_old_matches(const std::filesystem::path& folder, std::size_t keep);

/// Deletes them. The error names the file.
base::Result<void> delete_matches(const PrunedMatches& matches);

}  // namespace cls::cli
