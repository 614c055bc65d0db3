// Formats match statistics as text and CSV.
#pragma once

#include <cstddef>
#include <string>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"
#include "base/text/table.h"

namespace cls::analysis {

/// The table of the teams, then the table of the players, in blocks of columns if it is wider than
/// `width` characters.
std::string statistics_text(const MatchSummary& summary, const MatchStatistics& statistics,
                            std::size_t width = 80);

/// Its two tables: a row per figure with a column per team, and a row per player that took part.
base::Table team_figures(const MatchSummary& summary, const MatchStatistics& statistics);
base::Table player_figures(const MatchSummary& summary, const MatchStatistics& statistics);

/// CSV tables to which matches are added one by one; the first column is the file.
base::Table team_table();
void add_teams(const MatchSummary& summary, const MatchStatistics& statistics, base::Table& table);
base::Table player_table();
void add_players(const MatchSummary& summary, const MatchStatistics& statistics,
                 base::Table& table);
base::Table event_table();
void add_events(const MatchSummary& summary, const MatchStatistics& statistics, base::Table& table);

}  // namespace cls::analysis
