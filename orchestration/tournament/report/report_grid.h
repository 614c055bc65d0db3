// Tables of a report as cells, for text, Markdown and HTML alike.
#pragma once

#include <string>
#include <vector>

#include "orchestration/tournament/report/report_model.h"

namespace cls::orchestration::tournament {

/// A table; the first row holds the column names. Columns in `words` are aligned to the left.
struct Grid {
  std::string title;
  std::string note;  ///< what the figures mean, empty where they speak for themselves
  std::vector<std::vector<std::string>> rows;
  std::vector<std::size_t> words;
};

Grid standings_grid(const Report& report, const RankedTable& table);
/// Won, drawn, lost of the row's team against the column's. Empty rows with fewer than three or
/// more than twenty teams.
Grid crosstable_grid(const Report& report);
/// Each duel with score rate, Elo difference, intervals and likelihood of superiority.
Grid duels_grid(const Report& report);
/// Bradley-Terry over all matches. Empty rows with fewer than three teams.
Grid ratings_grid(const Report& report);
/// Matches without a proper result. Empty rows when there are none.
Grid failures_grid(const Report& report);
Grid matches_grid(const Report& report);

/// "round-robin of 3 teams, seed 1: 6 of 6 matches done, 1 forfeited, 1 INVALID".
std::string headline(const Report& report);

/// All of a report but the list of matches, without those that are empty.
std::vector<Grid> report_grids(const Report& report);

}  // namespace cls::orchestration::tournament
