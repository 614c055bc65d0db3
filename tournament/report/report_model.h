// The content of a report, independent of the output format.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "league/matches/fixture.h"
#include "league/matches/head_to_head.h"
#include "league/rating/bradley_terry.h"
#include "league/schedule/schedule.h"
#include "tournament/config/config.h"
#include "tournament/report/report_figures.h"
#include "tournament/slots/timetable.h"
#include "tournament/store/pauses_file.h"

namespace cls::tournament {

/// Name of the replay page in a match folder.
inline constexpr const char* kReplayPage = "match.html";

/// The configured name, or that of the folder.
std::string tournament_name(const TournamentConfig& config, const std::filesystem::path& folder);

/// Numbers of matches by state.
struct MatchCounts {
  int scheduled = 0;
  int finished = 0;  ///< played to the end
  int forfeits = 0;
  int invalid = 0;
  int annulled = 0;
  int open = 0;

  int done() const { return finished + forfeits + invalid + annulled; }
};
MatchCounts count(std::span<const ScheduledMatch> matches);

/// "4 of 6 matches done, of these 1 forfeited, 2 INVALID": the one wording of the counts.
std::string counts_text(const MatchCounts& counts);

/// Refers to the arguments of make_report(), which must outlive it.
struct Report {
  const TournamentConfig* config = nullptr;
  std::span<const ScheduledMatch> matches;
  std::filesystem::path folder;     ///< of the tournament
  std::filesystem::path link_base;  ///< path from the document to `folder`, for links
  std::set<int> replays;            ///< indices of matches with a replay page in their folder
  std::string name;                 ///< tournament_name()
  MatchCounts counts;
  bool complete = false;
  std::vector<Pause> pauses;
  Timetable timetable;  ///< of the matches scheduled so far that were not played
  std::vector<RankedTable> tables;
  std::vector<BracketTie> bracket;  ///< empty for formats without one
  std::vector<Bye> byes;            ///< of a Swiss tournament
  std::vector<HeadToHead> head_to_heads;
  Ratings ratings;                           ///< by team
  std::vector<TeamRecord> records;           ///< by team
  std::vector<PlaymakerFigures> playmakers;  ///< by team
  std::vector<HostFigures> hosts;

  const std::string& team(int index) const { return config->competition.team(index); }
};

Report make_report(const TournamentConfig& config, std::span<const ScheduledMatch> matches,
                   const std::filesystem::path& folder);

/// The names of the teams that share the first rank of the last table; empty before there is one.
std::vector<std::string> first_teams(const Report& report);

/// The results of `first` against `second`; nothing when they have not met.
std::optional<HeadToHead> find_head_to_head(const Report& report, int first, int second);

/// True when a match was neither played to the end nor decided otherwise.
bool failed(const ScheduledMatch& match);

/// The shell command that plays a match again.
std::string rerun_command(const TournamentConfig& config, const Fixture& fixture);

/// "2:1", "2:2 (4:3 pen)", "0:3 (forfeit)", "3:0 (decision)", "annulled", "crashed", or "-" without
/// an outcome. With `swapped`
/// the right team's score is first.
std::string score_text(const ScheduledMatch& match, bool swapped = false);
/// The same as the report writes it: in stages a shoot-out as the league does, "(2+4) - (2+3)".
std::string score_text(const TournamentConfig& config, const ScheduledMatch& match,
                       bool swapped = false);

/// "annulled", "to be played again", "played again", "awarded 3:0"; empty without a decision.
std::string decision_text(const ScheduledMatch& match);

/// The same of decision `number` of its history: an earlier replay was played.
std::string decision_text(const ScheduledMatch& match, std::size_t number);

/// All decisions on a match: "annulled, was 2:1; played again"; empty without one.
std::string history_text(const ScheduledMatch& match);

/// "semi-final 2", or "round 3" for matches without a stage.
std::string stage_text(const Fixture& fixture);

}  // namespace cls::tournament
