// Reports as text and Markdown.
#pragma once

#include <cstddef>
#include <string>

#include "tournament/report/report_model.h"

namespace cls::tournament {

struct TextOptions {
  std::size_t width = 80;    ///< of a line; longer words, such as paths, get their own line
  bool all_matches = false;  ///< every match with its logs and command, else a list if it is short
  bool standings_last = false;  ///< where the end of the text is what stays in view
};

/// Head, tables, bracket, Playmakers, warnings, matches, and the failed matches with their logs and
/// commands.
std::string report_text(const Report& report, const TextOptions& options = {});

/// The report as Markdown, with the logs and commands of all matches.
std::string report_markdown(const Report& report);

/// "winner: RED, 10 points, goals 3:0"; "leader: ..." of a tournament that is not complete, "level:
/// RED and BLUE, ..." of teams that share the first place; empty before the first result.
std::string winner_text(const Report& report);

/// The tables alone.
std::string standings_text(const Report& report, const TextOptions& options = {});

/// The line of a match in `cls tournament plan`.
std::string schedule_text(const TournamentConfig& config, const Fixture& fixture);

}  // namespace cls::tournament
