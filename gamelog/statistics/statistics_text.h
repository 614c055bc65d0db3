// Match statistics for people, and as CSV.
#pragma once

#include <string>

#include "gamelog/results/match_summary.h"
#include "gamelog/statistics/match_statistics.h"
#include "gamelog/text_table.h"

namespace cls::gamelog {

/// Two columns of figures for the teams, then a table of the players.
std::string statistics_text(const MatchSummary& summary, const MatchStatistics& statistics);

/// Tables that grow by a match at a time; the first column names the log.
TextTable team_table();
void add_teams(const MatchSummary& summary, const MatchStatistics& statistics, TextTable& table);
TextTable player_table();
void add_players(const MatchSummary& summary, const MatchStatistics& statistics, TextTable& table);
TextTable event_table();
void add_events(const MatchSummary& summary, const MatchStatistics& statistics, TextTable& table);

}  // namespace cls::gamelog
