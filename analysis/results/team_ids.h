// Identifiers of the teams in files for other programs.
#pragma once

#include <array>
#include <string>

#include "analysis/results/match_summary.h"

namespace cls::analysis {

/// The names of left and right team; "left" and "right" if the names do not tell the teams apart.
std::array<std::string, 2> team_ids(const MatchSummary& summary);

}  // namespace cls::analysis
