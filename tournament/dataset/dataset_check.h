// Verifies data sets.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "tournament/config/config.h"
#include "tournament/dataset/dataset.h"

namespace cls::tournament {

/// Files of `matches` that are missing or have other bytes, one line each.
std::vector<std::string> check_dataset_files(const std::filesystem::path& folder,
                                             const std::vector<DatasetMatch>& matches);

/// `count` of the matches with files, evenly distributed.
std::vector<DatasetMatch> sample_of(const std::vector<DatasetMatch>& matches, std::size_t count);

/// Plays `match` again and packs it. Returns its files that have other bytes, one line each. An
/// error if it cannot be played, or after a signal.
base::Result<std::vector<std::string>> replay_dataset_match(const TournamentConfig& config,
                                                            const DatasetMatch& match,
                                                            const std::filesystem::path& program,
                                                            const std::atomic<int>& signal);

}  // namespace cls::tournament
