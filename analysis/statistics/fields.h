// All statistics by name: the one list from which JSON, CSV and text are made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"
#include "analysis/statistics/team_totals.h"

namespace cls::analysis {

using Json = nlohmann::ordered_json;

// Objects with the members of cls.stats/1 (docs/formats/statistics.md lists names and units). CSV
// columns and text rows refer to these members. Numbers are not rounded.

Json team_fields(const MatchSummary& summary, const MatchStatistics& all, const TeamTotals& totals,
                 std::size_t team);
Json player_fields(const MatchStatistics& all, std::size_t slot);
/// Statistics of the match that belong to neither team.
Json game_fields(const MatchStatistics& all);

/// 0 if `whole` is 0.
double share(int part, int whole);
/// `[x, y]`.
Json point_json(soccer::Vec2 p);
/// "left" or "right"; empty for kNoPlayer.
const char* side_text(std::int8_t slot);

/// To four decimals, the precision of logs; never -0.
double rounded(double value);
/// Rounds every real number in `json`.
void round_numbers(Json& json);

}  // namespace cls::analysis
