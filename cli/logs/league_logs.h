// The logs of a match as the league archives them.
#pragma once

#include <ctime>
#include <filesystem>
#include <string>

#include "base/result.h"

namespace cls::cli {

/// A match in the league's form: logs without compression, the game log in version 5.
struct LeagueLogs {
  std::string name;  ///< of both without suffix: "20240718103000-RED_2-vs-BLUE_1"
  std::string rcg;
  std::string rcl;  ///< empty: the match has no text log
  int last_cycle = 0;
};

/// Reads the logs of a match folder. `start` is when the match began (server::log_date_format, in
/// the time of this host; docs/spec/log-formats.md 1.12). The error names a file that is missing or
/// has errors.
base::Result<LeagueLogs> read_league_logs(const std::filesystem::path& folder, std::time_t start);

}  // namespace cls::cli
