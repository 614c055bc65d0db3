// The end of a match as recorded in the result.json next to its logs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/results/read_results.h"
#include "gamelog/files/log_files.h"

namespace cls::match {

/// The end of the match of `log`, if a `result.json` (cls.match/1) in its folder names it as one of
/// its log files; analysis::kRunning while the match is played.
std::optional<analysis::RecordedEnd> recorded_end(const std::string& log);

/// When the match of `log` began, YYYYMMDDhhmm in local time: as its manifest.json says, else the
/// name of the log (rcssserver's begin with the date), else the time of the file. Empty: unknown.
std::string recorded_date(const std::string& log);

/// When the match of `folder` began, as its manifest.json says: UTC, ISO 8601. Empty: unknown.
std::string recorded_start(const std::filesystem::path& folder);

/// The logs of each match with its recorded end and date.
std::vector<analysis::MatchInput> with_recorded_ends(
    const std::vector<gamelog::MatchLogs>& matches);

}  // namespace cls::match
