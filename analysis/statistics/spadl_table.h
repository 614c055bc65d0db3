// The table of SPADL actions, in the columns of socceraction.
#pragma once

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"
#include "base/text/table.h"

namespace cls::analysis {

/// A CSV table to which matches are added one by one (docs/formats/events.md).
base::Table spadl_table();
void add_spadl(const MatchSummary& summary, const MatchStatistics& statistics, base::Table& table);

}  // namespace cls::analysis
