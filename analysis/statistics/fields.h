// Objects with the members of cls.stats/1 (docs/formats/statistics.md lists names and units).
#pragma once

#include <cstddef>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"
#include "base/text/json.h"

namespace cls::analysis {

using base::Json;

// Numbers are not rounded.
Json team_fields(const MatchSummary& summary, const MatchStatistics& all, std::size_t team);
Json player_fields(const MatchSummary& summary, const MatchStatistics& all, std::size_t slot);
/// Statistics of the match that belong to neither team.
Json game_fields(const MatchStatistics& all);

/// 0 if `whole` is 0.
double share(int part, int whole);
/// `[x, y]`.
Json point_json(soccer::Vec2 p);
/// "left" or "right"; empty for kNoPlayer.
const char* side_text(int slot);

/// To four decimals, the precision of logs; never -0. Of JSON: every real number in it.
double rounded(double value);
Json rounded(const Json& value);

}  // namespace cls::analysis
