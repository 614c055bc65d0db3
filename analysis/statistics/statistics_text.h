// Match statistics for people, and as CSV.
#pragma once

#include <string>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"
#include "base/text/text_table.h"

namespace cls::analysis {

/// Two columns of figures for the teams, then a table of the players.
std::string statistics_text(const MatchSummary& summary, const MatchStatistics& statistics);

/// Tables that grow by a match at a time; the first column names the log.
base::TextTable team_table();
void add_teams(const MatchSummary& summary, const MatchStatistics& statistics,
               base::TextTable& table);
base::TextTable player_table();
void add_players(const MatchSummary& summary, const MatchStatistics& statistics,
                 base::TextTable& table);
base::TextTable event_table();
void add_events(const MatchSummary& summary, const MatchStatistics& statistics,
                base::TextTable& table);

}  // namespace cls::analysis
