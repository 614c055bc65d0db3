// The report in formats for programs: JSON, CSV, JUnit.
#pragma once

#include <string>

#include "orchestration/tournament/report/report_model.h"

namespace cls::orchestration::tournament {

/// {"schema": "cls.tournament/1", "matches": [...], "standings": [...], ...}, indented.
std::string report_json(const Report& report);

/// A line a match, with a line of column names first.
std::string report_csv(const Report& report);

/// A test case a match: failure when it is invalid by a side's fault, error otherwise, skipped when
/// it is not played.
std::string report_junit(const Report& report);

}  // namespace cls::orchestration::tournament
