// Plays a comparison until its verdict: `cls compare`, and the end of `cls tune`.
#pragma once

#include <filesystem>

#include "cli/tournament/tournament_session.h"
#include "tournament/report/comparison.h"

namespace cls::cli {

/// Plays or resumes `comparison` in `folder`, and prints the result with `prints`. The exit code of
/// `cls compare`: kOk better, kFailed not better, kUndecided.
int run_comparison(const tournament::Comparison& comparison, const std::filesystem::path& folder,
                   const SessionOptions& session, bool prints = true);

}  // namespace cls::cli
