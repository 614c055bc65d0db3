// Reports as JSON, CSV and JUnit.
#pragma once

#include <string>

#include "base/text/json.h"
#include "tournament/report/report_model.h"

namespace cls::tournament {

/// {"schema": "cls.tournament/1", "matches": [...], "standings": [...], ...}, indented.
std::string report_json(const Report& report);

/// `schedule` of the documents: [{"match": 3, "start": "2027-07-15T07:00:00Z", "server": 1}, ...].
base::Json json_of(const Timetable& timetable);

/// A line of column names, then a line for each match.
std::string report_csv(const Report& report);

/// A test case for each match: a failure when it is invalid by a side's fault, otherwise an error;
/// skipped when it was not played.
std::string report_junit(const Report& report);

}  // namespace cls::tournament
