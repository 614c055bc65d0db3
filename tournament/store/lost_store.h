// A tournament whose store is gone, such as by a copy without it: what the folders of its matches
// still tell.
#pragma once

#include <filesystem>

#include "base/result.h"
#include "league/matches/fixture.h"
#include "tournament/config/config.h"

namespace cls::tournament {

/// True when a `run` has played matches of this folder, by events.jsonl and the folders of matches.
/// With an empty store the store is lost: it has each match before the match begins. (`work` plays
/// without a store, and leaves result files.)
bool was_begun(const std::filesystem::path& folder);

/// An error that names the first match that was played by events.jsonl and has no folder with a
/// result: without it the tournament cannot go on as it was.
base::Result<void> check_lost_results(const std::filesystem::path& folder);

/// The latest attempt at a match whose folder below matches/ has its result; 0: none.
int latest_attempt(const TournamentConfig& config, const Fixture& fixture,
                   const std::filesystem::path& folder);

/// The error of commands that only read.
base::Error lost_store(const std::filesystem::path& folder);

}  // namespace cls::tournament
