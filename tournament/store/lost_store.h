// A tournament whose store is gone, such as by a copy without it: what the folders of its matches
// still tell.
#pragma once

#include <filesystem>
#include <map>
#include <set>

#include "base/result.h"
#include "league/matches/fixture.h"
#include "tournament/config/config.h"

namespace cls::tournament {

/// True when a `run` has played matches of this folder, by events.jsonl and the folders of matches.
/// With an empty store the store is lost: it has each match before the match begins. (`work` plays
/// without a store, and leaves result files.)
bool was_begun(const std::filesystem::path& folder);

/// Attempts whose folders below matches/ have results, by the number of the match.
using FoundAttempts = std::map<int, std::set<int>>;
FoundAttempts find_attempts(const std::filesystem::path& folder);

/// An error that names the first match that was played by events.jsonl and is not among those
/// `found`: without its result the tournament cannot go on as it was.
base::Result<void> check_lost_results(const std::filesystem::path& folder,
                                      const FoundAttempts& found);

/// The latest of the attempts `found` whose folder has the result of `fixture`; 0: none.
int latest_attempt(const TournamentConfig& config, const Fixture& fixture,
                   const std::filesystem::path& folder, const FoundAttempts& found);

/// The error of commands that only read.
base::Error lost_store(const std::filesystem::path& folder);

}  // namespace cls::tournament
