// What a match would start, as lines of shell.
#pragma once

#include <string>

#include "base/result.h"
#include "orchestration/match/options/match_options.h"

namespace cls::orchestration::match {

/// One command a line, each with a comment that says what it is; ports are free ones of this
/// moment, another run takes others. Nothing is started and no folder is made. The error says what
/// is missing.
base::Result<std::string> dry_run(const MatchOptions& options);

}  // namespace cls::orchestration::match
