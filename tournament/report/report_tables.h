// Tables of a report, independent of the output format.
#pragma once

#include <string>
#include <vector>

#include "base/text/table.h"
#include "tournament/report/report_model.h"

namespace cls::tournament {

struct ReportTable {
  std::string title;
  std::string note;  ///< what the figures mean, empty where they are obvious
  base::Table table;
  std::size_t key_columns = 1;  ///< see base::TextLayout

  bool empty() const { return table.empty(); }
};

/// The tables as readers want them: the last of stages and groups first, once all are played.
std::vector<RankedTable> tables_by_interest(const Report& report);

/// Headings of the standings: "P", "W", "pts" where space is short, or "played", "won", "points".
enum class Headings { kShort, kLong };

ReportTable standings_table(const Report& report, const RankedTable& ranked, Headings headings);
/// Won, drawn, lost of the row's team against the column's, by rank. `numbered`: columns are headed
/// by ranks instead of names. Empty with fewer than three or more than twenty teams, and where the
/// bracket says it all.
ReportTable crosstable(const Report& report, bool numbered);
/// Score rate, Elo difference, intervals and likelihood of superiority of each pair of teams.
ReportTable head_to_head_table(const Report& report);
/// Bradley-Terry over all matches. Empty with fewer than three teams.
ReportTable ratings_table(const Report& report);
/// Teams in the order of the ratings table: those that played.
std::vector<std::size_t> rated_teams(const Report& report);
/// Endpoints and latencies of each team's Playmaker. Without `endpoints` only the latencies; empty
/// while there are none.
ReportTable playmakers_table(const Report& report, bool endpoints);
/// Empty with a single host.
ReportTable hosts_table(const Report& report);
/// Decisions on matches, with their reasons. Empty if there are none.
ReportTable decisions_table(const Report& report);
/// Technical time-outs. Empty if there were none.
ReportTable pauses_table(const Report& report);
/// When the next matches start. Empty without `start_times`.
ReportTable schedule_table(const Report& report);

/// Matches without a proper result. Empty if there are none.
ReportTable failures_table(const Report& report);
enum class MatchDetails {
  kScores,
  kFigures,  ///< also end reason, cycles, seed, date, host and number of warnings
  kLinks,    ///< also a link to the folder
};
ReportTable matches_table(const Report& report, MatchDetails details);

/// "+12", "-3", "+0": a difference without negative zero.
std::string difference_text(double value, int decimals = 0);

/// "round-robin of 3 teams, seed 1: 6 of 6 matches done, of these 1 forfeited".
std::string headline(const Report& report);

/// Lines below the headline: when, where and with which versions the matches were played, byes.
std::vector<std::string> head_lines(const Report& report);

/// "match 3, RED 2:1 BLUE"
std::string match_text(const Report& report, const ScheduledMatch& match);

/// "match 3, RED 2:1 BLUE: TEXT" for each warning of each match.
std::vector<std::string> warning_lines(const Report& report);

/// "# match 3, RED 2:1 BLUE" above the command that plays the match again, for each match.
std::string rerun_lines(const Report& report);

}  // namespace cls::tournament
