// Differences of two matches, such as two runs with one seed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"

namespace cls::viewer {

/// The first frame that is not equal in all values of the log.
struct FrameDifference {
  std::size_t frame = 0;
  int cycle = 0;
  int stopped = 0;  ///< cycles that the clock has been stopped
  /// What differs: "play mode", "ball position", "left 7 stamina"; one entry, "end of the log",
  /// where one log ends and the other does not.
  std::vector<std::string> what;
};

/// Nothing if all frames are equal. Parameters, names and messages are not compared.
std::optional<FrameDifference> first_difference(const gamelog::MatchRecord& a,
                                                const gamelog::MatchRecord& b);

/// "cycle 812 (frame 815): ball position, left 7 stamina and 3 more", or "none".
std::string difference_text(const std::optional<FrameDifference>& difference);

/// A goal, shot or foul that only one of the matches has.
struct LoneEvent {
  std::size_t match = 0;  ///< 0: the first one, 1: the second one
  int cycle = 0;
  std::string text;  ///< "goal, left 9", "shot, right 11: saved"
};

/// By cycle.
std::vector<LoneEvent> lone_events(const analysis::MatchStatistics& a,
                                   const analysis::MatchStatistics& b);

/// A match with its figures.
struct ComparedMatch {
  const analysis::MatchSummary* summary = nullptr;
  const analysis::MatchStatistics* statistics = nullptr;
};

/// Figures of both teams in both matches, and the second minus the first: the headings, then a row
/// for each figure.
std::vector<std::vector<std::string>> difference_rows(const ComparedMatch& a,
                                                      const ComparedMatch& b);

}  // namespace cls::viewer
