// `--dry-run`: what a match would start, as shell commands.
#pragma once

#include <string>

#include "base/result.h"
#include "match/terms/match_options.h"

namespace cls::match {

/// One command per line, each below a comment with its name. Ports are free at this time; a match
/// may choose others. Starts nothing and creates no folder. The error says what is missing.
base::Result<std::string> dry_run(const MatchOptions& options);

}  // namespace cls::match
