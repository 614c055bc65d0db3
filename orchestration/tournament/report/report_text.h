// The report for people: text, Markdown, HTML.
#pragma once

#include <string>

#include "orchestration/tournament/report/report_model.h"

namespace cls::orchestration::tournament {

/// Counts, tables, crosstable, ratings, and the matches that failed with where to look.
std::string report_text(const Report& report);

/// The same as Markdown.
std::string report_markdown(const Report& report);

/// The same, and all matches, as a page of its own: nothing is loaded from anywhere.
std::string report_html(const Report& report);

/// The tables alone.
std::string standings_text(const Report& report);

/// One line a match, as `cls tournament plan` lists them.
std::string schedule_text(const TournamentConfig& config, const Fixture& fixture);

}  // namespace cls::orchestration::tournament
