// Tables of a report, independent of the output format.
#pragma once

#include <string>
#include <vector>

#include "base/text/table.h"
#include "orchestration/tournament/report/report_model.h"

namespace cls::orchestration::tournament {

struct ReportTable {
  std::string title;
  std::string note;  ///< what the figures mean, empty where they are obvious
  base::Table table;

  bool empty() const { return table.empty(); }
};

ReportTable standings_table(const Report& report, const RankedTable& ranked);
/// Won, drawn, lost of the row's team against the column's. Empty with fewer than three or more
/// than twenty teams.
ReportTable crosstable(const Report& report);
/// Score rate, Elo difference, intervals and likelihood of superiority of each pair of teams.
ReportTable head_to_head_table(const Report& report);
/// Bradley-Terry over all matches. Empty with fewer than three teams.
ReportTable ratings_table(const Report& report);
/// Matches without a proper result. Empty if there are none.
ReportTable failures_table(const Report& report);
ReportTable matches_table(const Report& report);

/// "round-robin of 3 teams, seed 1: 6 of 6 matches done, 1 forfeited, 1 INVALID".
std::string headline(const Report& report);

/// All tables of a report but failures and matches, without those that are empty.
std::vector<ReportTable> report_tables(const Report& report);

}  // namespace cls::orchestration::tournament
