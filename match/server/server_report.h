// Result of a match in the format of rcssserver, for scripts that read it.
#pragma once

#include <ctime>
#include <string>

#include "soccer/side.h"

namespace cls::match {

struct ReportedTeam {
  std::string name;   ///< empty: never connected
  std::string coach;  ///< empty: none
  int score = 0;
  int penalties_taken = 0;
  int penalties_scored = 0;
};

struct ServerReport {
  std::time_t start = 0;
  ReportedTeam left;
  ReportedTeam right;
  soccer::Side coin_toss_winner = soccer::Side::kNeutral;
};

/// The text that rcssserver prints at its end (docs/spec/server-protocol.md 7.4); `csv_saved`: the
/// CSV file was written.
std::string console_report(const ServerReport& report, bool csv_saved);

/// A line of the CSV file, and its header.
std::string csv_line(const ServerReport& report);
std::string csv_header();

}  // namespace cls::match
