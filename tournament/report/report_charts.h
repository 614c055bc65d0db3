// The charts of a tournament's page.
#pragma once

#include <string>
#include <vector>

#include "tournament/report/report_model.h"

namespace cls::tournament {

/// A dot with its 95 % interval for each rated team, best first. SVG (viewer/charts).
std::string ratings_chart(const Report& report);

/// The goal differences of each pair of teams that has played at least five matches; none when
/// these are more than six pairs, whose charts no one would read.
std::vector<std::string> differences_charts(const Report& report);

}  // namespace cls::tournament
