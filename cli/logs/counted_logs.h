// The logs of matches that count.
#pragma once

#include <string>
#include <vector>

#include "gamelog/files/log_files.h"

namespace cls::cli {

/// What gamelog::find_logs() finds, less the matches of tournaments that a decision annulled or had
/// played again; a line on stderr says how many. A log or match folder that is an argument itself
/// stays.
gamelog::FoundLogs find_counted_logs(const std::vector<std::string>& arguments);

}  // namespace cls::cli
