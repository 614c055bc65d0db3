// The decisions of a tournament: a file with a line for each, to which lines are added.
#pragma once

#include <filesystem>
#include <vector>

#include "base/result.h"
#include "base/text/json.h"
#include "league/matches/decision.h"

namespace cls::tournament {

/// In the folder of a tournament.
inline constexpr const char* kDecisionsFile = "decisions.jsonl";

/// The decisions of the tournament in `folder`, in their order; none without the file. The error
/// names the line.
base::Result<std::vector<MatchDecision>> read_decisions(const std::filesystem::path& folder);

/// Replaces the file: it has the old decisions or the new ones even after a power cut.
base::Result<void> write_decisions(const std::filesystem::path& folder,
                                   const std::vector<MatchDecision>& decisions);

/// A line of the file, and the member "decision" of a match in reports.
base::Json json_of(const MatchDecision& decision);

}  // namespace cls::tournament
