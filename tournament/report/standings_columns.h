// The columns of the standings table by name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/text/table.h"
#include "tournament/report/report_model.h"

namespace cls::tournament {

struct StandingsColumn {
  std::string_view name;  ///< of kStandingsColumns
  const char* heading;
  const char* short_heading;
  base::Table::Align align;
  std::string (*cell)(const Report& report, const Standing& row);
};

/// The configured columns, or those that the format and the results need.
std::vector<const StandingsColumn*> chosen_columns(const Report& report, const RankedTable& ranked);

}  // namespace cls::tournament
