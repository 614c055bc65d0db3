// The content of a report, independent of the output format.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/rating/bradley_terry.h"
#include "orchestration/tournament/schedule/fixture.h"
#include "orchestration/tournament/schedule/head_to_head.h"
#include "orchestration/tournament/schedule/schedule.h"

namespace cls::orchestration::tournament {

/// Numbers of matches by state.
struct MatchCounts {
  int scheduled = 0;
  int finished = 0;  ///< played to the end
  int forfeits = 0;
  int invalid = 0;
  int open = 0;

  int done() const { return finished + forfeits + invalid; }
};
MatchCounts count(std::span<const ScheduledMatch> matches);

/// "4 of 6 matches done, of these 1 forfeited, 2 INVALID": the one wording of the counts.
std::string counts_text(const MatchCounts& counts);

/// Refers to the arguments of make_report(), which must outlive it.
struct Report {
  const TournamentConfig* config = nullptr;
  std::span<const ScheduledMatch> matches;
  std::filesystem::path folder;  ///< of the tournament
  MatchCounts counts;
  bool complete = false;
  std::vector<RankedTable> tables;
  std::vector<HeadToHead> head_to_heads;
  Ratings ratings;                   ///< by team
  std::vector<WinDrawLoss> records;  ///< by team, without forfeits

  const std::string& team(int index) const {
    return config->teams[static_cast<std::size_t>(index)].name;
  }
};

Report make_report(const TournamentConfig& config, std::span<const ScheduledMatch> matches,
                   const std::filesystem::path& folder);

/// A team's share of the points of a match, with its 95 % interval.
Estimate strength_of(const WinDrawLoss& record);

/// The results of `first` against `second`; nothing when they have not met.
std::optional<HeadToHead> find_head_to_head(const Report& report, int first, int second);

/// The shell command that plays a match again.
std::string rerun_command(const TournamentConfig& config, const Fixture& fixture);

/// "2:1", "2:2 (4:3 pen)", "0:3 (forfeit)", "crashed", or "-" without an outcome.
std::string score_text(const ScheduledMatch& match);

}  // namespace cls::orchestration::tournament
