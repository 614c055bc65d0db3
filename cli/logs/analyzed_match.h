// A match from its logs, with statistics.
#pragma once

#include <optional>
#include <string>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"
#include "cli/logs/find_log.h"
#include "gamelog/rcl/rcl_record.h"
#include "viewer/page/page.h"

namespace cls::cli {

/// `statistics` refers to `match`: neither is moved alone.
struct AnalyzedMatch {
  FoundLog found;
  viewer::StreamMatch match;
  std::optional<gamelog::RclRecord> text;
  analysis::MatchSummary summary;
  analysis::MatchStatistics statistics;

  const gamelog::RclRecord* text_log() const { return text ? &*text : nullptr; }
};

/// Reads the match that `what` names (find_log.h), with the end that `cls match` recorded. Prints
/// errors. Returns kOk, also for a log with parse errors, or the exit code.
int read_match(const std::string& what, AnalyzedMatch& match);

}  // namespace cls::cli
