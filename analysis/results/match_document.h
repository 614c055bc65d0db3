// What `cls match` has written beside the logs of a match: how it ended.
#pragma once

#include <string>

#include "analysis/results/match_summary.h"

namespace cls::analysis {

/// A match that was meant to end early (`cls match --cycles`) leaves the same logs as one that
/// broke off; only the `result.json` in the folder of the log knows. If it names `log` as one of
/// its log files, its end reason is taken over, and with it whether the match is complete and who
/// has won.
void add_end_reason(const std::string& log, MatchSummary& summary);

}  // namespace cls::analysis
