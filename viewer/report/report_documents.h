// The report of a match as HTML and Markdown.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"
#include "viewer/report/match_charts.h"

namespace cls::viewer {

/// How the Playmaker of a side replied. Latencies in microseconds.
struct PlaymakerReplies {
  std::string team;
  std::string endpoint;
  std::int64_t decisions = 0;
  std::int64_t late = 0;
  std::int64_t missed = 0;
  double p50_us = 0.0;  ///< median player
  double p95_us = 0.0;  ///< slowest player
  double p99_us = 0.0;  ///< slowest player
  double max_us = 0.0;  ///< slowest player
};

struct MatchReport {
  analysis::MatchSummary summary;
  const analysis::MatchStatistics* statistics = nullptr;
  std::vector<PlaymakerReplies> playmakers;  ///< empty: not known
  std::vector<std::string> warnings;         ///< of the match
  std::string command;                       ///< the command that played it; empty: not known
};

/// One file without requests. `replay` is the page of the match (match_page.h), which it embeds;
/// such a report is also a log for read_page(). Empty: no replay.
std::string report_html(const MatchReport& report, const std::vector<Chart>& charts,
                        const std::string& replay);

/// Refers to the charts as `folder`/NAME.svg; without charts if `folder` is empty.
std::string report_markdown(const MatchReport& report, const std::vector<Chart>& charts,
                            const std::string& folder);

}  // namespace cls::viewer
