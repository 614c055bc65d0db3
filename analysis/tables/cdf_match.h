// A match as files of the Common Data Format.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/results/match_summary.h"
#include "analysis/results/periods.h"
#include "analysis/statistics/match_statistics.h"
#include "base/io/byte_sink.h"
#include "gamelog/record/match_record.h"

namespace cls::analysis {

/// The version of the schemas that the files follow.
inline constexpr const char* kCdfVersion = "0.2.3";

/// A match with its statistics. The left team is the home team. Neither copied nor moved: the
/// statistics refer to the record.
struct CdfMatch {
  /// `id` identifies the match; `record` must outlive the value.
  CdfMatch(const gamelog::MatchRecord& record, std::string id);
  CdfMatch(const CdfMatch&) = delete;
  CdfMatch& operator=(const CdfMatch&) = delete;

  /// UTC of a frame, "1970-01-01T00:00:00.100Z". A frame takes a cycle, so the time runs on while
  /// the clock of the match is stopped. The first frame has the date of the log.
  std::string time_of(std::size_t frame) const;
  std::string player_id(std::size_t slot) const;

  const gamelog::MatchRecord& record;
  std::string id;
  MatchSummary summary;
  MatchStatistics statistics;
  std::vector<Period> periods;
  std::array<std::string, 2> teams;  ///< their identifiers

 private:
  long long start_ = 0;  // milliseconds since 1970
};

/// "first_half", "second_half", "first_half_extratime", "second_half_extratime", "shootout".
std::string_view cdf_name(PeriodKind period);

// The files (docs/data.md).

/// Official match data: result, teams, goals and cards. One line of JSON.
std::string cdf_match_document(const CdfMatch& match);

/// Meta data: periods with their frames and times, teams, pitch. One line of JSON.
std::string cdf_meta_document(const CdfMatch& match);

/// A line for each event of a known player.
std::string cdf_events(const CdfMatch& match);

/// A line for each frame with ball and connected players.
void write_cdf_tracking(const CdfMatch& match, base::ByteSink& sink);

}  // namespace cls::analysis
