// Reports as text, Markdown and HTML.
#pragma once

#include <string>

#include "orchestration/tournament/report/report_model.h"

namespace cls::orchestration::tournament {

/// Counts, tables, crosstable, ratings, and the failed matches with their logs and commands.
std::string report_text(const Report& report);

/// The same as Markdown.
std::string report_markdown(const Report& report);

/// The same, and all matches, as a self-contained page.
std::string report_html(const Report& report);

/// The tables alone.
std::string standings_text(const Report& report);

/// The line of a match in `cls tournament plan`.
std::string schedule_text(const TournamentConfig& config, const Fixture& fixture);

}  // namespace cls::orchestration::tournament
