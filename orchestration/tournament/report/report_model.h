// All that a report says, before it is written in one format or another.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/rating/bradley_terry.h"
#include "orchestration/tournament/schedule/fixture.h"
#include "orchestration/tournament/schedule/match_pairs.h"
#include "orchestration/tournament/schedule/schedule.h"

namespace cls::orchestration::tournament {

/// How many matches there are, and what became of them.
struct MatchCounts {
  int scheduled = 0;
  int finished = 0;  ///< played to their end
  int forfeits = 0;
  int invalid = 0;
  int open = 0;

  int done() const { return finished + forfeits + invalid; }
};
MatchCounts count(std::span<const ScheduledMatch> matches);

/// Names and matches are those of the arguments of make_report, which must outlive it.
struct Report {
  const TournamentConfig* config = nullptr;
  std::span<const ScheduledMatch> matches;
  std::filesystem::path folder;  ///< of the tournament, for paths
  MatchCounts counts;
  bool complete = false;
  std::vector<RankedTable> tables;
  std::vector<Duel> duels;
  Ratings ratings;                   ///< by team
  std::vector<WinDrawLoss> records;  ///< by team, without forfeits

  const std::string& team(int index) const {
    return config->teams[static_cast<std::size_t>(index)].name;
  }
};

Report make_report(const TournamentConfig& config, std::span<const ScheduledMatch> matches,
                   const std::filesystem::path& folder);

/// A team's share of the points of a match, 95 %.
Estimate strength_of(const WinDrawLoss& record);

/// The duel of two teams as `first` sees it; nullptr when they have not met.
std::optional<Duel> find_duel(const Report& report, int first, int second);

/// The line of shell that plays a match again.
std::string rerun_line(const TournamentConfig& config, const Fixture& fixture);

/// "2 : 1", "2 : 2 (4 : 3 on penalties)", "0 : 3 (forfeit)", "crashed", or "-" without an outcome.
std::string score_text(const ScheduledMatch& match);

}  // namespace cls::orchestration::tournament
