// What a match would start, as lines of shell.
#pragma once

#include <string>

#include "orchestration/match_options.h"
#include "soccer/result.h"

namespace cls::orchestration {

/// One command a line, each with a comment that says what it is; ports are free ones of this
/// moment, another run takes others. Nothing is started and no folder is made. The error says what
/// is missing.
soccer::Result<std::string> dry_run(const MatchOptions& options);

}  // namespace cls::orchestration
